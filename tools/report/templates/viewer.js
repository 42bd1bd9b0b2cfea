// One viewer for each failing scene. It starts when its section is first opened. Until
// then, and without JavaScript, the page shows plain pictures.
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

  // The divider stays at its place in the frame while the picture moves under it.
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

  // Scrolls the chosen pixel into view: to the middle if asked, or if it is outside.
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
