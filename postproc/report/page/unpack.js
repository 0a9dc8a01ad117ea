// SPDX-License-Identifier: GPL-2.0-or-later
// The scene from its packed bytes; the format is that of report/scene.h.

class TooOld extends Error {}

async function inflated(text) {
  if (typeof DecompressionStream === "undefined")
    throw new TooOld("This browser cannot unpack the scene: it needs Firefox 113, Chrome or Edge 80, Safari 16.4, or a later one. The averages below are complete.");
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

class WordReader {
  constructor(bytes) {
    this.bytes = bytes;
    this.place = 0;
  }

  words(count) {
    const words = new Uint16Array(count);
    const low = this.place;
    const high = low + count;
    for (let i = 0; i < count; ++i) words[i] = this.bytes[low + i] | (this.bytes[high + i] << 8);
    this.place += 2 * count;
    return words;
  }

  // Of 32 bits, as whole numbers.
  longs(count) {
    const low = this.words(count);
    const high = this.words(count);
    return Uint32Array.from(low, (word, i) => word + 65536 * high[i]);
  }
}

function unpackedIds(reader, count) {
  const low = reader.longs(count);
  const high = reader.longs(count);
  let last = 0n;
  return Array.from(low, (word, i) => Number((last = BigInt.asIntN(64, last + BigInt(word) + (BigInt(high[i]) << 32n)))));
}

function unfolded(folded, before) {
  const codes = new Uint16Array(folded.length);
  for (let i = 0; i < codes.length; ++i) {
    const difference = folded[i] & 1 ? -((folded[i] + 1) >> 1) : folded[i] >> 1;
    codes[i] = before[i] + difference;
  }
  return codes;
}

function unpackedDiscs(reader, info, columns, before) {
  const ids = info.new_ids ? unpackedIds(reader, info.discs) : before.ids;
  const discs = {};
  for (const { name } of columns) {
    const words = reader.words(info.discs);
    discs[name] = info.new_ids ? words : unfolded(words, before.discs[name]);
  }
  return { ids, discs };
}

function unpackedContacts(reader, info, columns) {
  const first = reader.longs(info.contacts);
  const second = reader.longs(info.contacts);
  for (let i = 0, last = 0; i < first.length; ++i) {
    last = first[i] += last;
    second[i] += last;
  }
  const contacts = {};
  for (const { name } of columns) contacts[name] = reader.words(info.contacts);
  return { first, second, contacts };
}

// Frames with their ids, codes of discs and contacts by column, and the two discs of each contact.
function unpackedFrames(bytes, scene) {
  const reader = new WordReader(bytes);
  let before = null;
  const frames = scene.frames.map((info) => {
    before = { ...info, ...unpackedDiscs(reader, info, scene.disc_columns, before), ...unpackedContacts(reader, info, scene.contact_columns) };
    return before;
  });
  if (reader.place !== bytes.length) throw new Error("The scene is damaged: it has another length than its frames.");
  return frames;
}

function columnOf(columns, name) {
  return columns.find((column) => column.name === name);
}

function valueOf(column, code) {
  return code === column.unknown ? NaN : column.low + column.step * code;
}

// Walls have the numbers of their ids: 0, -1, -2, ...
const LAST_DISC = 2 ** 31;
function wallOf(second) {
  return second >= LAST_DISC ? second - (2 ** 32 - 1) : null;
}
