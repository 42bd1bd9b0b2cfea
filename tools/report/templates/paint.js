// False colours, as `false_colour.rs` has them; the tables of colours come from there.
const palette = JSON.parse(document.getElementById("palette").textContent);

const colours = {
  id: ([id], k) => palette.objects[Math.trunc(id[k]) % palette.objects.length],
  depth: ([, t], k, { per_t, near, far }) => {
    const share = (t[k] * per_t - near) / Math.max(far - near, Number.MIN_VALUE);
    return palette.far[Math.round(255 * Math.min(Math.max(share || 0, 0), 1))];
  },
  normal: ([, , ...axes], k) => axes.map((axis) => Math.trunc((Math.min(Math.max(axis[k], -1), 1) + 1) * 127.5)),
};

function fill(canvas, { n_x, n_y }, colour) {
  canvas.width = n_x;
  canvas.height = n_y;
  const image = new ImageData(n_x, n_y);
  for (let k = 0; k < n_x * n_y; k++) image.data.set([...colour(k), 255], 4 * k);
  canvas.getContext("2d").putImageData(image, 0, 0);
}

function paint(canvas, size, view, film, depth) {
  fill(canvas, size, (k) => (film[0][k] >= 0 ? colours[view](film, k, depth) : palette.background));
}

// Failing pixels get the colour of their worst channel, all others are faint. If causes are
// chosen, pixels that fail for another reason are faint too.
function paintDifference(canvas, size, pixels, chosen) {
  const [object, t, normal] = palette.difference;
  fill(canvas, size, (k) => {
    const missed = pixels.missed[k];
    if (missed && (chosen.size === 0 || chosen.has(pixels.causes[k]))) {
      return missed & 1 ? object : missed & 2 ? t : normal;
    }
    const hit = pixels.expected[0][k] >= 0;
    const faint = hit ? colours.id(pixels.expected, k) : palette.background;
    return faint.map((value) => Math.trunc(value / 4));
  });
}
