// Numbers as `words.rs` of the harness writes them: this many significant digits, no
// trailing zeros, a real minus sign.
function number(value, digits) {
  if (value === 0) return "0";
  if (!Number.isFinite(value)) return String(value).replace("Infinity", "inf").replace("-", "−");
  const size = Math.abs(value);
  const bare = (text) => (text.includes(".") ? text.replace(/\.?0+$/, "") : text);
  if (size >= 1e-4 && size < 1e7) {
    const decimals = Math.max(digits - 1 - Math.floor(Math.log10(size)), 0);
    return bare(value.toFixed(decimals)).replace("-", "−");
  }
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${bare(mantissa)}e${exponent.replace("+", "")}`.replaceAll("-", "−");
}

// Six digits, or as many as it takes to see that two numbers differ.
function digitsToTell(one, other) {
  if (one === other) return 6;
  return [6, 7, 8].find((digits) => number(one, digits) !== number(other, digits)) ?? 9;
}

function vector(values, digits) {
  return `(${values.map((value) => number(value, digits)).join(", ")})`;
}

function object(id, objects) {
  if (!(id >= 0)) return "no hit";
  const kind = objects[id]?.split(" ")[0];
  return kind ? `object ${id} (${kind})` : `object ${id}`;
}

// A ray of a grid of rays. A component that is only a rounding error becomes 0.
function rayAt(rays, i, j) {
  const at = ({ first, per_column, per_row }) => {
    const sum = [0, 1, 2].map((axis) => first[axis] + i * per_column[axis] + j * per_row[axis]);
    const noise = 1e-6 * Math.max(...first.map(Math.abs));
    return sum.map((value) => (Math.abs(value) < noise ? 0 : value));
  };
  const d = at(rays.direction);
  const length = rays.is_normalised ? Math.hypot(...d) : 1;
  return { e: at(rays.origin), d: d.map((value) => value / length) };
}
