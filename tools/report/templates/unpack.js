"use strict";

// The inverse of `pixels.rs`. For every pixel of a window, it gives the channels that miss, the
// cause, and what was expected, allowed and got.
async function unpack(text, count) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());

  const shuffled = bytes.subarray(2 * count);
  const floats = shuffled.length / 4;
  const ordered = new Uint8Array(shuffled.length);
  for (let place = 0; place < 4; place++) {
    for (let k = 0; k < floats; k++) ordered[4 * k + place] = shuffled[place * floats + k];
  }
  const numbers = new DataView(ordered.buffer);
  const film = (first) =>
    [0, 1, 2, 3, 4].map((channel) =>
      Float32Array.from({ length: count }, (_, k) => numbers.getFloat32(4 * ((first + channel) * count + k), true)));
  return {
    missed: bytes.subarray(0, count),
    causes: bytes.subarray(count, 2 * count),
    expected: film(0),
    allowed: film(5),
    got: film(10),
  };
}
