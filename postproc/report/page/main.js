// SPDX-License-Identifier: GPL-2.0-or-later
// Puts the page together.

function tell(trouble) {
  byId("trouble").hidden = false;
  byId("trouble").textContent = trouble;
}

async function startScene(page, profiles) {
  page.frames = unpackedFrames(await inflated(byId("packed").textContent), page.scene);
  byId("packed").remove();
  byId("scene").hidden = false;
  let player = null;
  const follow = (place) => {
    const window = page.scene.windows_of_frames[place];
    profiles.showWindow(window);
    if (player && !player.playing) showCommands(page, player.look, window);
  };
  player = new Player(page, follow);
  const update = () => showCommands(page, player.look, page.scene.windows_of_frames[player.place]);
  for (const id of ["quantity", "chains", "network", "play"]) byId(id).addEventListener(id === "play" ? "click" : "change", update);
  update();
  return player;
}

async function start() {
  const page = JSON.parse(byId("data").textContent);
  showSummary(page);
  const profiles = new Profiles(page);
  showAudit(page);
  showParameters(page);
  showCommands(page, null, null);
  showLosses(page);
  const report = { page, profiles, player: null };
  globalThis.mikromakroReport = report;  // for tests, and for the curious
  try {
    report.player = await startScene(page, profiles);
    document.documentElement.dataset.ready = "scene";
  } catch (error) {
    tell(error instanceof TooOld ? error.message : `The scene cannot be shown: ${error.message}`);
    document.documentElement.dataset.ready = "averages";
    if (!(error instanceof TooOld)) throw error;
  }
}

start();
