// A pixel dragged over the lecture's picture: its u(i) and v(j), its ray, and the hit. The
// rays of a column stay in one slice of the scene, which is drawn below the picture.

import facts from "./facts.json";
import { WIDTH, circle, clamped, drawing, line, shape, slider, table, word } from "./stage";
import { shown } from "./words";

interface Outline {
    readonly object: number;
    readonly ellipse?: readonly number[];
    readonly line?: readonly number[];
}

const { columns, rows, start, forward, height, u, v, e, d } = facts.pixel_to_ray;
const hits = facts.pixel_to_ray.hits as unknown as readonly (readonly [number, number] | null)[];
const slices = facts.pixel_to_ray.slices as readonly (readonly Outline[])[];

const CELL = WIDTH / columns;
const PICTURE = rows * CELL;
const HEIGHT = PICTURE + 260;

// In the slice, depth runs to the right. Heights are enlarged four times, because the slice
// would be too flat to see.
const [EYE_X, EYE_Y, DEEP, HIGH] = [22, PICTURE + 130, 5.8, 23.2];
const FARTHEST = 77;
const place = (depth: number, high: number): readonly [number, number] => [
    EYE_X + DEEP * depth,
    EYE_Y - HIGH * high,
];

const colour = (object: number): string => facts.colours[object % facts.colours.length] ?? "currentColor";

function picture(): SVGElement[] {
    return hits.map((hit, at) => {
        const fill = hit === null ? facts.background : colour(hit[0]);
        const [x, y] = [(at % columns) * CELL, Math.floor(at / columns) * CELL];
        return shape("rect", { x, y, width: CELL - 0.4, height: CELL - 0.4, fill });
    });
}

function outline({ object, ellipse, line: ends }: Outline): SVGElement {
    const stroke = { stroke: colour(object), "stroke-width": 3 };
    if (ellipse !== undefined) {
        const [depth = 0, high = 0, rx = 0, ry = 0] = ellipse;
        const [cx, cy] = place(depth, high);
        return shape("ellipse", { cx, cy, rx: DEEP * rx, ry: HIGH * ry, fill: colour(object), "fill-opacity": 0.5, ...stroke });
    }
    const [fromDepth = 0, fromHigh = 0, toDepth = 0, toHigh = 0] = ends ?? [];
    // A plane is cut off where the slice's picture ends.
    const highest = 4.6;
    const at = (high: number) => fromDepth + ((high - fromHigh) / (toHigh - fromHigh)) * (toDepth - fromDepth);
    const [low, top] = [clamped(fromHigh, -highest, highest), clamped(toHigh, -highest, highest)];
    return line(place(at(low), low), place(at(top), top), colour(object), 3);
}

export function pixelToRay(stage: HTMLElement): void {
    const svg = drawing(HEIGHT, (x, y) => {
        if (y < PICTURE) {
            i.value = clamped(Math.floor(x / CELL), 0, columns - 1);
            j.value = clamped(rows - 1 - Math.floor(y / CELL), 0, rows - 1);
            draw();
        }
    });
    const i = slider("column i", [0, columns - 1, 1], start[0] ?? 0, () => draw());
    const j = slider("row j, from the bottom", [0, rows - 1, 1], start[1] ?? 0, () => draw());
    const numbers = table();
    const still = picture();

    function draw(): void {
        // Pixels are listed row by row from the top.
        const at = (rows - 1 - j.value) * columns + i.value;
        const hit = hits[at] ?? null;
        // Along the ray, t is 1 at the image plane.
        const slope = (v[j.value] ?? 0) / forward;
        const end = hit === null ? FARTHEST : forward * hit[1];
        const eye = place(0, 0);
        const chosen = {
            x: clamped(i.value * CELL - 1, 1.5, WIDTH - CELL - 2.5),
            y: clamped((rows - 1 - j.value) * CELL - 1, 1.5, PICTURE - CELL - 2.5),
            width: CELL + 1.5,
            height: CELL + 1.5,
            fill: "none",
        };
        svg.replaceChildren(
            ...still,
            shape("rect", { ...chosen, stroke: "#ffffff", "stroke-width": 3 }),
            shape("rect", { ...chosen, stroke: "#000000", "stroke-width": 1 }),
            ...(slices[i.value] ?? []).map(outline),
            line(place(forward, -height / 2), place(forward, height / 2), "currentColor", 4),
            line(eye, place(end, slope * end), "#d55e00", 2),
            circle(eye, 4, "currentColor"),
            circle(place(forward, slope * forward), 3.5, "currentColor"),
            ...(hit === null ? [] : [circle(place(end, slope * end), 5, "#d55e00")]),
            word([eye[0] - 4, eye[1] - 12], "e", "start"),
            word([eye[0] + DEEP * forward, eye[1] + 34], "t = 1"),
            word([4, PICTURE + 24], "column i from the side, heights × 4", "start"),
        );
        numbers.show([
            ["pixel", `(${i.value}, ${j.value})`],
            ["u(i)", shown(u[i.value] ?? 0)],
            ["v(j)", shown(v[j.value] ?? 0)],
            ["e", e],
            ["d", d[at] ?? ""],
            ["first hit", hit === null ? "none" : `object ${hit[0]}, t = ${shown(hit[1])}`],
        ]);
    }
    stage.replaceChildren(svg, i.row, j.row, numbers.element);
    draw();
}
