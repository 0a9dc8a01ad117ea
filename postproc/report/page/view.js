// SPDX-License-Identifier: GPL-2.0-or-later
// The visible part of the plane.

class View {
  // whole: [x_min, x_max, y_min, y_max] in m
  constructor(canvas, whole) {
    this.canvas = canvas;
    this.whole = whole;
    this.reset();
  }

  reset() {
    this.zoom = 1;
    this.centre = [(this.whole[0] + this.whole[1]) / 2, (this.whole[2] + this.whole[3]) / 2];
  }

  // Call whenever the width of the page may have changed. All later numbers are in pixels of the canvas.
  fit() {
    const aspect = (this.whole[3] - this.whole[2]) / (this.whole[1] - this.whole[0]);
    const width = this.canvas.clientWidth || 600;
    const tallest = Math.max(260, 0.64 * window.innerHeight);
    const height = Math.min(Math.max(width * aspect, 120), tallest);
    const density = Math.min(window.devicePixelRatio || 1, 2);
    this.canvas.style.aspectRatio = `${width} / ${height}`;
    const size = [Math.round(width * density), Math.round(height * density)];
    if (this.canvas.width !== size[0]) this.canvas.width = size[0];
    if (this.canvas.height !== size[1]) this.canvas.height = size[1];
  }

  // pixels per m
  get scale() {
    const margin = 0.98;
    return this.zoom * margin * Math.min(this.canvas.width / (this.whole[1] - this.whole[0]), this.canvas.height / (this.whole[3] - this.whole[2]));
  }

  toPixel(x, y) {
    return [this.canvas.width / 2 + this.scale * (x - this.centre[0]), this.canvas.height / 2 - this.scale * (y - this.centre[1])];
  }

  toPlane(px, py) {
    return [this.centre[0] + (px - this.canvas.width / 2) / this.scale, this.centre[1] - (py - this.canvas.height / 2) / this.scale];
  }

  // The point under the pixel stays where it is.
  zoomBy(factor, px = this.canvas.width / 2, py = this.canvas.height / 2) {
    const before = this.toPlane(px, py);
    this.zoom = Math.min(Math.max(this.zoom * factor, 1), 200);
    const after = this.toPlane(px, py);
    this.moveTo(this.centre[0] + before[0] - after[0], this.centre[1] + before[1] - after[1]);
  }

  moveBy(px, py) {
    this.moveTo(this.centre[0] - px / this.scale, this.centre[1] + py / this.scale);
  }

  moveTo(x, y) {
    if (this.zoom === 1) return this.reset();
    this.centre = [Math.min(Math.max(x, this.whole[0]), this.whole[1]), Math.min(Math.max(y, this.whole[2]), this.whole[3])];
  }

  // Of a pointer event, in pixels of the canvas.
  pixelOf(event) {
    const box = this.canvas.getBoundingClientRect();
    return [(event.clientX - box.left - this.canvas.clientLeft) * (this.canvas.width / this.canvas.clientWidth), (event.clientY - box.top - this.canvas.clientTop) * (this.canvas.height / this.canvas.clientHeight)];
  }
}

// Shifts of periodic images that may reach into the window, none along other axes.
function imageShifts(frame) {
  const along = (axis) => {
    const length = frame.box[2 * axis + 1] - frame.box[2 * axis];
    return frame.periodic[axis] ? [-length, 0, length] : [0];
  };
  return along(0).flatMap((x) => along(1).map((y) => [x, y]));
}
