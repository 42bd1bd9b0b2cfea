// A walk through the tree of a floor plan, step by step, for rays that lean more or less.
// What the walk does is looked up: the script doesn't search.

import facts from "./facts.json";
import { type Place, WIDTH, circle, clamped, drawing, line, shape, slider, table, word } from "./stage";
import { shown } from "./words";

const { e, stride, start, least, walls, boxes } = facts.walk_steps;
// What is tested or left out, its number, and the t at which it is entered or met.
type Step = readonly [string, number, number | null];
const rays = facts.walk_steps.rays as unknown as readonly {
    readonly d: string;
    readonly lean: number;
    readonly steps: readonly Step[];
}[];
const longest = Math.max(...rays.map((ray) => ray.steps.length));

// The plan's corner, and how large a unit is.
const [HEIGHT, LEFT, BOTTOM, SCALE] = [232, 18, 206, 27];
const [EYE_X, EYE_Y] = [e[0] ?? 0, e[1] ?? 0];
const TOP_Y = (BOTTOM - 6) / SCALE;
const LOW_Y = (BOTTOM - HEIGHT + 6) / SCALE;
const place = (x: number, y: number): Place => [LEFT + SCALE * x, BOTTOM - SCALE * y];

const told = ([what, number, t]: Step): string => {
    const at = t === null ? "" : shown(t);
    switch (what) {
        case "box":
            return `box of node ${number}: ${t === null ? "not entered" : `entered at ${at}`}`;
        case "wall":
            return `wall ${number}: ${t === null ? "missed" : `met at ${at}`}`;
        default:
            return `node ${number} left out: entered at ${at}`;
    }
};

export function walkSteps(stage: HTMLElement): void {
    const svg = drawing(HEIGHT, (x) => {
        step.value = clamped(Math.round((1 - (x - LEFT) / (WIDTH - 2 * LEFT)) * longest), 0, longest);
        draw();
    });
    const step = slider("step", [0, longest, 1], 0, () => draw());
    const lean = slider("turn the ray", [least, least + rays.length - 1, 1], start, () => draw());
    const numbers = table();

    function draw(): void {
        const ray = rays[lean.value - least];
        if (ray === undefined) {
            return;
        }
        const done = ray.steps.slice(0, step.value);
        const last = done.at(-1);
        let nearest: readonly [number, number] | null = null;
        const looks = boxes.map(() => ({ stroke: "currentColor", width: 1, dash: "3 4", opacity: 0 }));
        const met = new Map<number, boolean>();
        for (const [what, number, t] of done) {
            if (what === "wall") {
                met.set(number, t !== null);
                if (t !== null && (nearest === null || t < nearest[1])) {
                    nearest = [number, t];
                }
            } else {
                const lit = what === "box" && t !== null;
                looks[number] = lit
                    ? { stroke: "#d55e00", width: 2, dash: "none", opacity: 0.16 }
                    : { stroke: "#0072b2", width: 2, dash: "7 4", opacity: 0 };
            }
        }
        // The ray's end on the border of the drawing.
        const at = (x: number): Place => place(x, EYE_Y + ray.lean * (x - EYE_X));
        const steep = ray.lean === 0 ? Infinity : ((ray.lean < 0 ? TOP_Y : LOW_Y) - EYE_Y) / ray.lean;
        const far = Math.max(-0.5, ray.lean === 0 ? -0.5 : EYE_X + steep);
        const hit = nearest === null ? far : EYE_X + stride * nearest[1];
        const parts = boxes.map(([x0 = 0, y0 = 0, x1 = 0, y1 = 0], node) => {
            const [[left, bottom], [right, top]] = [place(x0, y0), place(x1, y1)];
            const look = looks[node] ?? { stroke: "none", width: 0, dash: "none", opacity: 0 };
            return shape("rect", {
                x: left,
                y: top,
                width: right - left,
                height: bottom - top,
                fill: "#e69f00",
                "fill-opacity": look.opacity,
                stroke: look.stroke,
                "stroke-width": look.width,
                "stroke-dasharray": look.dash,
            });
        });
        for (const [number, [x0 = 0, y0 = 0, x1 = 0, y1 = 0]] of walls.entries()) {
            const tested = met.has(number);
            parts.push(
                line(place(x0, y0), place(x1, y1), tested ? "#d55e00" : "currentColor", tested ? 5 : 3),
                word(place((x0 + x1) / 2 + 0.55, (y0 + y1) / 2 - 0.5), String(number)),
            );
        }
        parts.push(
            line(at(hit), at(far), "currentColor", 1, "5 4"),
            line(at(EYE_X), at(hit), "#d55e00", 2.5),
            circle(at(EYE_X), 4, "currentColor"),
            word([at(EYE_X)[0], at(EYE_X)[1] + 22], "e"),
        );
        if (nearest !== null) {
            const [x, y] = at(hit);
            parts.push(line([x, 20], [x, y - 12], "#0072b2", 1, "2 3"), line([x, y - 12], [x, y + 12], "#0072b2", 4));
            parts.push(word([clamped(x, 26, WIDTH - 26), 15], "max_t"));
        }
        svg.replaceChildren(...parts);
        numbers.show([
            ["d", ray.d],
            ["step", `${done.length} of ${ray.steps.length}`],
            ["this step", last === undefined ? "nothing tested yet" : told(last)],
            ["nearest", nearest === null ? "none" : `wall ${nearest[0]}`],
            ["max_t", nearest === null ? "infinite" : shown(nearest[1])],
            ["tests", String(done.filter(([what]) => what !== "skip").length)],
        ]);
    }
    stage.replaceChildren(svg, step.row, lean.row, numbers.element);
    draw();
}
