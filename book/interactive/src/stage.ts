// What every interactive figure is made of: a drawing, sliders, and a table of numbers.

const SVG = "http://www.w3.org/2000/svg";

// Every drawing is as wide as the book's static ones, in CSS pixels.
export const WIDTH = 480;

// Words are 11 pixels high where a drawing is 350 wide, as on a phone.
const FONT_SIZE = 15.5;

export type Place = readonly [number, number];
export type Look = Readonly<Record<string, string | number>>;

// An SVG element.
export function shape(name: string, look: Look, text = ""): SVGElement {
    const element = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(look)) {
        element.setAttribute(key, String(value));
    }
    element.textContent = text;
    return element;
}

export const line = ([x1, y1]: Place, [x2, y2]: Place, stroke: string, width: number, dash = "none"): SVGElement =>
    shape("line", { x1, y1, x2, y2, stroke, "stroke-width": width, "stroke-dasharray": dash });

export const circle = ([cx, cy]: Place, r: number, fill: string, opacity = 1): SVGElement =>
    shape("circle", { cx, cy, r, fill, "fill-opacity": opacity, stroke: "currentColor", "stroke-width": 1.5 });

export const word = ([x, y]: Place, text: string, anchor = "middle"): SVGElement =>
    shape("text", { x, y, fill: "currentColor", "font-size": FONT_SIZE, "text-anchor": anchor }, text);

// A drawing over which a pointer can be dragged. The sliders and the table say the same, so
// readers who don't see the drawing miss nothing.
export function drawing(height: number, dragged: (x: number, y: number) => void): SVGSVGElement {
    const svg = shape("svg", {
        viewBox: `0 0 ${WIDTH} ${height}`,
        width: WIDTH,
        height,
        "aria-hidden": "true",
    }) as SVGSVGElement;
    const drag = (event: PointerEvent): void => {
        const box = svg.getBoundingClientRect();
        dragged(
            ((event.clientX - box.left) / box.width) * WIDTH,
            ((event.clientY - box.top) / box.height) * height,
        );
        event.preventDefault();
    };
    svg.addEventListener("pointerdown", (event) => {
        svg.setPointerCapture(event.pointerId);
        drag(event);
    });
    svg.addEventListener("pointermove", (event) => {
        if (svg.hasPointerCapture(event.pointerId)) {
            drag(event);
        }
    });
    return svg;
}

export interface Slider {
    readonly row: HTMLElement;
    value: number;
}

// A slider with its name: arrow keys move it by a step.
export function slider(
    name: string,
    [least, most, step]: readonly [number, number, number],
    value: number,
    changed: () => void,
): Slider {
    const input = document.createElement("input");
    Object.assign(input, { type: "range", min: least, max: most, step, value });
    input.addEventListener("input", changed);
    const row = document.createElement("label");
    const words = document.createElement("span");
    words.textContent = name;
    row.append(words, input);
    return {
        row,
        get value() {
            return input.valueAsNumber;
        },
        set value(wanted: number) {
            input.valueAsNumber = wanted;
        },
    };
}

// A table of names and values. Screen readers read out changes when they pause.
export function table(): { element: HTMLElement; show(rows: readonly (readonly [string, string])[]): void } {
    const element = document.createElement("dl");
    element.setAttribute("aria-live", "polite");
    return {
        element,
        show(rows) {
            element.replaceChildren(
                ...rows.map(([name, value]) => {
                    const row = document.createElement("div");
                    const term = document.createElement("dt");
                    const number = document.createElement("dd");
                    term.textContent = name;
                    number.textContent = value;
                    row.append(term, number);
                    return row;
                }),
            );
        },
    };
}

export const clamped = (value: number, least: number, most: number): number =>
    Math.min(most, Math.max(least, value));
