// SPDX-License-Identifier: GPL-2.0-or-later
// Mouse and fingers on the scene: a click picks, dragging moves, two fingers or Ctrl and the wheel zoom.

class Gestures {
  constructor(player) {
    this.player = player;
    this.pointers = new Map();
    const { canvas } = player.view;
    canvas.style.touchAction = "pan-y";
    canvas.addEventListener("pointerdown", (event) => this.down(event));
    canvas.addEventListener("pointermove", (event) => this.move(event));
    canvas.addEventListener("pointerup", (event) => this.up(event));
    canvas.addEventListener("pointercancel", (event) => this.pointers.delete(event.pointerId));
    canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
  }

  down(event) {
    if (this.pointers.size === 0) this.moved = 0;
    this.pointers.set(event.pointerId, this.player.view.pixelOf(event));
    this.player.view.canvas.setPointerCapture(event.pointerId);
  }

  move(event) {
    const before = this.pointers.get(event.pointerId);
    if (!before) return;
    const now = this.player.view.pixelOf(event);
    this.moved += Math.hypot(now[0] - before[0], now[1] - before[1]);
    const other = [...this.pointers].find(([id]) => id !== event.pointerId)?.[1];
    this.pointers.set(event.pointerId, now);
    if (other) {
      const apart = (point) => Math.hypot(point[0] - other[0], point[1] - other[1]);
      this.player.zoom(apart(now) / Math.max(apart(before), 1), ...other);
    } else if (this.moved > 6 && this.player.view.zoom > 1) {
      this.player.view.moveBy(now[0] - before[0], now[1] - before[1]);
      this.player.repaint(false);
    }
  }

  up(event) {
    const known = this.pointers.delete(event.pointerId);
    if (known && this.pointers.size === 0 && this.moved <= 6) this.player.pickAt(...this.player.view.pixelOf(event));
  }

  wheel(event) {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    this.player.zoom(2 ** (-event.deltaY / 300), ...this.player.view.pixelOf(event));
  }
}
