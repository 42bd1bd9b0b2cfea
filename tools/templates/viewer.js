// One viewer for each failing scene. It starts when its fold is first opened; until
// then, and without JavaScript, still pictures stand in its place.
for (const card of document.querySelectorAll("details.scene")) {
  const start = () => {
    if (!card.open || card.dataset.started || !card.querySelector(".viewer")) return;
    card.dataset.started = "yes";
    view(card);
  };
  card.addEventListener("toggle", start);
  start();
}

// A link to a folded card opens it.
function openTarget() {
  const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
  if (target instanceof HTMLDetailsElement) target.open = true;
}
window.addEventListener("hashchange", openTarget);
openTarget();

function element(name, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(name), attributes);
  // Strings become text, never markup.
  made.append(...children);
  return made;
}

async function view(card) {
  const viewer = card.querySelector(".viewer");
  const one = (selector) => viewer.querySelector(selector);
  const all = (selector) => [...viewer.querySelectorAll(selector)];
  const evidence = JSON.parse(one(".evidence").textContent);
  const size = evidence.window;
  const pixels = await unpack(evidence.pixels, size.n_x * size.n_y);
  const glasses = all(".glass");
  const causeButtons = [...card.querySelectorAll("[data-cause]")];
  const state = { view: evidence.view, zoom: 1, divider: 50, chosen: new Set(), i: 0, j: 0 };

  // Pixels count from the bottom left of the whole film, samples from the window's top.
  const top = evidence.film.n_y - 1 - size.top;
  const place = (i, j) => (top - j) * size.n_x + (i - size.left);
  const pixelAt = (k) => [size.left + (k % size.n_x), top - Math.trunc(k / size.n_x)];

  function draw() {
    paint(one(".expected"), size, state.view, pixels.expected, evidence.depth);
    paint(one(".yours"), size, state.view, pixels.got, evidence.depth);
    paintDifference(one(".difference"), size, pixels, state.chosen);
  }

  // The divider stands still in its frame while the picture moves under it.
  function divide() {
    const [glass] = glasses;
    const left = glass.scrollLeft + (state.divider / 100) * glass.clientWidth;
    one(".yours").style.clipPath = `inset(0 0 0 ${Math.min(100, (100 * left) / glass.scrollWidth)}%)`;
    glass.style.setProperty("--divider", `${left}px`);
    one(".of-expected").classList.toggle("absent", state.divider === 0);
    one(".of-yours").classList.toggle("absent", state.divider === 100);
  }

  function slide(value) {
    const range = one("[type=range]");
    state.divider = range.value = value;
    const words = { 0: "all yours", 100: "all expected" };
    range.setAttribute("aria-valuetext", words[value] ?? `left ${value} % expected, the rest yours`);
    divide();
  }

  function zoom(factor) {
    state.zoom = Math.min(Math.max(state.zoom * factor, 1), 32);
    one(".zoom output").textContent = `${state.zoom}×`;
    for (const glass of glasses) glass.style.setProperty("--zoom", state.zoom);
    one("[data-zoom=out]").disabled = state.zoom === 1;
    one("[data-zoom=in]").disabled = state.zoom === 32;
    mark();
    reveal(true);
    divide();
  }

  // Puts the cursor around the chosen pixel in every picture.
  function mark() {
    const k = place(state.i, state.j);
    for (const cursor of all(".cursor")) {
      cursor.style.left = `${(100 * (k % size.n_x)) / size.n_x}%`;
      cursor.style.top = `${(100 * Math.trunc(k / size.n_x)) / size.n_y}%`;
      cursor.style.width = `${100 / size.n_x}%`;
      cursor.style.height = `${100 / size.n_y}%`;
    }
  }

  // Scrolls the chosen pixel into sight, into the middle if asked or if it is outside.
  function reveal(middle) {
    const [glass] = glasses;
    const cursor = glass.querySelector(".cursor");
    const inside = (at, length, from, seen) => at >= from && at + length <= from + seen;
    const visible =
      inside(cursor.offsetLeft, cursor.offsetWidth, glass.scrollLeft, glass.clientWidth) &&
      inside(cursor.offsetTop, cursor.offsetHeight, glass.scrollTop, glass.clientHeight);
    if (visible && !middle) return;
    glass.scrollLeft = cursor.offsetLeft - glass.clientWidth / 2;
    glass.scrollTop = cursor.offsetTop - glass.clientHeight / 2;
  }

  function choose(i, j, announce = true) {
    const within = (value, first, count) => Math.min(Math.max(value, first), first + count - 1);
    state.i = within(i, size.left, size.n_x);
    state.j = within(j, top - size.n_y + 1, size.n_y);
    mark();
    reveal(false);
    const k = place(state.i, state.j);
    one(".reading").replaceChildren(...reading(state.i, state.j, k, pixels, evidence));
    if (announce) one(".announcement").textContent = sentence(state.i, state.j, k, pixels, evidence);
  }

  function walk(step) {
    const count = size.n_x * size.n_y;
    const fails = (k) => pixels.missed[k] && (state.chosen.size === 0 || state.chosen.has(pixels.causes[k]));
    const here = place(state.i, state.j);
    for (let far = 1; far <= count; far++) {
      const k = (here + step * far + count * count) % count;
      if (fails(k)) return choose(...pixelAt(k));
    }
  }

  const keys = {
    ArrowLeft: (far) => choose(state.i - far, state.j),
    ArrowRight: (far) => choose(state.i + far, state.j),
    ArrowUp: (far) => choose(state.i, state.j + far),
    ArrowDown: (far) => choose(state.i, state.j - far),
    n: () => walk(1),
    p: () => walk(-1),
    "+": () => zoom(2),
    "-": () => zoom(0.5),
  };

  for (const glass of glasses) {
    glass.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key]) return;
      event.preventDefault();
      keys[event.key](event.shiftKey ? 10 : 1);
    });
    glass.addEventListener("click", (event) => {
      const sheet = glass.querySelector(".sheet").getBoundingClientRect();
      const along = (at, from, length, count) => Math.floor(((at - from) / length) * count);
      const x = along(event.clientX, sheet.left, sheet.width, size.n_x);
      const y = along(event.clientY, sheet.top, sheet.height, size.n_y);
      choose(size.left + x, top - y);
    });
    glass.addEventListener("scroll", () => {
      for (const other of glasses) {
        if (other === glass) continue;
        other.scrollLeft = glass.scrollLeft;
        other.scrollTop = glass.scrollTop;
      }
      divide();
    });
    glass.style.setProperty("--shape", size.n_x / size.n_y);
  }
  for (const radio of all(".views input")) {
    radio.addEventListener("change", () => {
      state.view = radio.value;
      draw();
    });
  }
  for (const button of all("[data-zoom]")) {
    button.addEventListener("click", () => zoom(button.dataset.zoom === "in" ? 2 : 0.5));
  }
  for (const button of all("[data-walk]")) {
    button.addEventListener("click", () => walk(Number(button.dataset.walk)));
  }
  for (const button of all("[data-divider]")) {
    button.addEventListener("click", () => slide(Number(button.dataset.divider)));
  }
  for (const button of causeButtons) {
    button.addEventListener("click", () => {
      const cause = Number(button.dataset.cause);
      const chosen = !state.chosen.delete(cause);
      if (chosen) state.chosen.add(cause);
      button.setAttribute("aria-pressed", chosen);
      paintDifference(one(".difference"), size, pixels, state.chosen);
      if (chosen && pixels.causes[place(state.i, state.j)] !== cause) walk(1);
    });
  }
  one("[type=range]").addEventListener("input", (event) => slide(Number(event.target.value)));
  new ResizeObserver(divide).observe(glasses[0]);

  draw();
  viewer.hidden = false;
  card.classList.add("viewing");
  zoom(1);
  slide(50);
  choose(...evidence.start, false);
}

// What is known of a pixel: its ray, what was expected and what came.
function reading(i, j, k, pixels, evidence) {
  const at = (film) => film.map((channel) => channel[k]);
  const [expected, allowed, got] = [pixels.expected, pixels.allowed, pixels.got].map(at);
  const cause = palette.causes[pixels.causes[k] - 1];
  const verdict = element("p", { className: cause ? "cause fail" : "cause pass" });
  verdict.append(element("b", {}, `Pixel (${i}, ${j})`), cause ? ` ✗ ${cause}` : " ✓ agrees");

  const parts = [verdict];
  if (evidence.rays) {
    const { e, d } = rayAt(evidence.rays, i, j);
    const facts = [["e", vector(e, 6)], ["d", vector(d, 6)]];
    if (evidence.min_t !== null) facts.push(["min_t", number(evidence.min_t, 6)]);
    const list = element("dl", { className: "ray" });
    for (const [name, value] of facts) {
      list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
    }
    parts.push(element("p", { className: "ray-title" }, "Its ray, by Mitsuba"), list);
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

// The same in a sentence, for who listens.
function sentence(i, j, k, pixels, evidence) {
  const told = (film) => {
    const [id, t] = film.map((channel) => channel[k]);
    return object(id, evidence.objects) + (id >= 0 ? ` at t ${number(t, 6)}` : "");
  };
  const cause = palette.causes[pixels.causes[k] - 1];
  return `Pixel ${i}, ${j}: ${cause ?? "agrees"}. Expected ${told(pixels.expected)}; yours ${told(pixels.got)}.`;
}
