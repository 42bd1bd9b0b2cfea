// Finds what is wrong with a page's drawings, measured in the browser: words that are too small,
// words that overlap, and anything beyond the border, with every slider at each of its ends.

// Runs in the page, and returns sentences.
export function drawingsWrong({ smallest }) {
    const wrong = new Set();
    const inside = (box, frame) =>
        box.left >= frame.left - 2 && box.right <= frame.right + 2 && box.top >= frame.top - 2 && box.bottom <= frame.bottom + 2;
    // A line of text is higher than its letters.
    const letters = ({ left, right, top, bottom }) => {
        const spare = (bottom - top) * 0.2;
        return { left, right, top: top + spare, bottom: bottom - spare };
    };
    const overlap = (one, other) =>
        Math.min(one.right, other.right) - Math.max(one.left, other.left) > 1 &&
        Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top) > 1;
    const look = (svg, name) => {
        const frame = svg.getBoundingClientRect();
        const words = [...svg.querySelectorAll("text")].map((text) => ({
            text: text.textContent.trim(),
            size: parseFloat(getComputedStyle(text).fontSize) * svg.getScreenCTM().a,
            box: letters(text.getBoundingClientRect()),
        }));
        for (const { text, size } of words) {
            if (size < smallest - 0.05) {
                wrong.add(`${name}: “${text}” is ${size.toFixed(1)} pixels high`);
            }
        }
        words.forEach(({ text, box }, at) => {
            for (const other of words.slice(at + 1)) {
                if (overlap(box, other.box)) {
                    wrong.add(`${name}: “${text}” and “${other.text}” overlap`);
                }
            }
        });
        for (const part of svg.querySelectorAll("text, path, polygon, circle, ellipse, rect, line")) {
            if (!inside(part.getBoundingClientRect(), frame)) {
                wrong.add(`${name}: <${part.nodeName} ${part.textContent.trim()}> is beyond the border`);
            }
        }
    };
    const named = (figure) => {
        const drawn = figure.querySelector("svg, img");
        return figure.dataset.figure ?? (drawn?.getAttribute("aria-label") ?? drawn?.getAttribute("alt"))?.slice(0, 40);
    };
    for (const picture of document.querySelectorAll("main figure img, main figure canvas")) {
        const figure = picture.closest("figure").getBoundingClientRect();
        const { left, right } = picture.getBoundingClientRect();
        if (left < figure.left - 2 || right > figure.right + 2) {
            wrong.add(`${named(picture.closest("figure"))}: a picture is beyond the figure`);
        }
    }
    for (const figure of document.querySelectorAll("main figure")) {
        const drawing = () => figure.querySelector("svg");
        if (drawing() === null) {
            continue;
        }
        const sliders = [...figure.querySelectorAll("input[type=range]")];
        const starts = sliders.map((slider) => slider.value);
        // Every slider at its start and at both ends, in all combinations.
        const set = (slider, value) => {
            slider.value = value;
            slider.dispatchEvent(new Event("input"));
        };
        const each = (at, told) => {
            const slider = sliders[at];
            if (slider === undefined) {
                look(drawing(), `${named(figure)}${told}`);
                return;
            }
            for (const value of [starts[at], slider.min, slider.max]) {
                set(slider, value);
                each(at + 1, `${told} ${value}`);
            }
        };
        each(0, "");
        sliders.forEach((slider, at) => set(slider, starts[at]));
    }
    return [...wrong];
}

// Runs in the page, and counts what stays folded when it is printed.
export function foldedInPrint() {
    dispatchEvent(new Event("beforeprint"));
    const folded = document.querySelectorAll("main details:not([open])").length;
    dispatchEvent(new Event("afterprint"));
    return folded;
}
