// What every interactive figure is made of: a drawing, sliders, and a table of numbers.

const SVG = "http://www.w3.org/2000/svg";

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

// A drawing that a pointer may be dragged over; what it means is told by the sliders and
// the table, so that nobody misses anything who does not see it.
export function drawing(width: number, height: number, dragged: (x: number, y: number) => void): SVGSVGElement {
    const svg = shape("svg", {
        viewBox: `0 0 ${width} ${height}`,
        width,
        height,
        "aria-hidden": "true",
        "font-family": "serif",
    }) as SVGSVGElement;
    const drag = (event: PointerEvent): void => {
        const box = svg.getBoundingClientRect();
        dragged(
            ((event.clientX - box.left) / box.width) * width,
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

// Names and what stands beside them; changes are read out when they pause.
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
