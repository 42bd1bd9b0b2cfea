function element(name, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(name), attributes);
  // Strings become text, never markup.
  made.append(...children);
  return made;
}

// What is known about a pixel: its ray, the expected values and the given ones.
function reading(i, j, k, pixels, evidence) {
  const at = (film) => film.map((channel) => channel[k]);
  const [expected, allowed, got] = [pixels.expected, pixels.allowed, pixels.got].map(at);
  const cause = palette.causes[pixels.causes[k] - 1];
  const verdict = element("p", { className: cause ? "cause fail" : "cause pass" });
  verdict.append(element("b", {}, `Pixel (${i}, ${j})`), cause ? ` ✗ ${cause}` : " ✓ agrees");

  const parts = [verdict];
  if (evidence.rays) {
    const min_t = evidence.min_t === null ? [] : [["min_t", number(evidence.min_t, 6)]];
    const rays = element("div", { className: "rays" });
    rays.append(ray("Mitsuba's ray", [...inWords(rayAt(evidence.rays, i, j)), ...min_t]));
    const own = evidence.own_rays;
    if (own === "right") rays.append(ray("Your ray", [["", "the same"]]));
    else if (own === "uneven") rays.append(ray("Your ray", [["", "the command below shows it"]]));
    else if (own !== "unknown") rays.append(ray("Your ray", inWords(rayAt(own, i, j))));
    parts.push(rays);
  }
  parts.push(comparison(i, j, expected, allowed, got, pixels.missed[k], evidence));
  const met = evidence.objects[expected[0]];
  if (met) parts.push(element("p", { className: "met" }, `Object ${expected[0]}: ${met}`));
  if (evidence.explain) {
    const [before, after] = evidence.explain;
    const command = element("code", {}, `${before} ${i} ${j}${after}`);
    parts.push(element("p", { className: "again" }, element("span", { className: "label" }, "Step by step"), " ", command));
  }
  return parts;
}

const inWords = ({ e, d }) => [["e", vector(e, 6)], ["d", vector(d, 6)]];

function ray(title, facts) {
  const list = element("dl", { className: "ray" });
  for (const [name, value] of facts) {
    list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
  }
  return element("div", {}, element("p", { className: "ray-title" }, title), list);
}

function comparison(i, j, expected, allowed, got, missed, evidence) {
  const table = element("table", { className: "pixel" });
  table.append(element("caption", { className: "unseen" }, `Pixel (${i}, ${j}), channel by channel`));
  const head = ["", "Expected", "Yours", "Tolerance", ""].map((words) => element(words ? "th" : "td", words ? { scope: "col" } : {}, words));
  const body = element("tbody");
  table.append(element("thead", {}, element("tr", {}, ...head)), body);
  const nothing = (sample) => (channel, digits) => (channel > 0 && !(sample[0] >= 0) ? "–" : number(sample[channel], digits));
  const names = ["object", "t", "normal x", "normal y", "normal z"];
  names.forEach((name, channel) => {
    const digits = digitsToTell(got[channel], expected[channel]);
    const [should, came] = [expected, got].map((sample) =>
      channel === 0 ? object(sample[0], evidence.objects) : nothing(sample)(channel, digits));
    const fails = Boolean(missed & (1 << channel));
    const any = allowed[channel] > 3e38;
    const tolerance = any ? "any" : channel === 0 ? "none" : `± ${number(allowed[channel], 2)}`;
    const mark = element("span", { className: fails ? "mark fail" : "mark pass" }, fails ? "✗" : "✓");
    mark.setAttribute("role", "img");
    mark.setAttribute("aria-label", fails ? "fails" : "agrees");
    body.append(element("tr", {},
      element("th", { scope: "row" }, name), element("td", {}, should), element("td", {}, came),
      element("td", {}, tolerance), element("td", {}, mark)));
  });
  return table;
}

// The same facts in a sentence, for screen readers.
function sentence(i, j, k, pixels, evidence) {
  const told = (film) => {
    const [id, t] = film.map((channel) => channel[k]);
    return object(id, evidence.objects) + (id >= 0 ? ` at t ${number(t, 6)}` : "");
  };
  const cause = palette.causes[pixels.causes[k] - 1];
  return `Pixel ${i}, ${j}: ${cause ?? "agrees"}. Expected ${told(pixels.expected)}; yours ${told(pixels.got)}.`;
}
