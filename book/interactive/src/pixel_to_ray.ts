// A pixel dragged over the lecture's picture: its u(i) and v(j), its ray, and the hit.

import facts from "./facts.json";
import { type Camera, type Hit, type Shape, type Vec, add, at, firstHit, onPlane, scale, viewingRay } from "./rays";
import { clamped, drawing, shape, slider, table } from "./stage";
import { shown, vector } from "./words";

const { resolution, min_t: minT } = facts.slide;
const camera = facts.slide.camera as unknown as Camera;
const objects = facts.slide.objects as unknown as readonly Shape[];
const { n_x, n_y } = resolution;

const CELL = 13;
const [WIDTH, HEIGHT] = [n_x * CELL, n_y * CELL + 330];
// Pixels of the drawing for a scene unit, seen from the side.
const UNIT = 5.8;
const TOP = n_y * CELL + 12;

// The world from the side: z to the left, y up.
const side = ([, y, z]: Vec): readonly [number, number] => [200 - UNIT * z, HEIGHT - 16 - UNIT * y];

const colour = (object: number): string => facts.colours[object % facts.colours.length] ?? "currentColor";
const hitOf = (i: number, j: number): Hit | null =>
    firstHit(objects, viewingRay(camera, { i, j }, resolution), minT);

function picture(): SVGElement[] {
    const cells: SVGElement[] = [];
    for (let j = 0; j < n_y; j += 1) {
        for (let i = 0; i < n_x; i += 1) {
            const hit = hitOf(i, j);
            const fill = hit === null ? facts.background : colour(hit.object);
            const [x, y] = [i * CELL, (n_y - 1 - j) * CELL];
            cells.push(shape("rect", { x, y, width: CELL - 0.5, height: CELL - 0.5, fill }));
        }
    }
    return cells;
}

function fromTheSide(): SVGElement[] {
    return objects.map((object, number) => {
        const look = { fill: colour(number), "fill-opacity": 0.5, stroke: "currentColor" };
        if ("Sphere" in object) {
            const [cx, cy] = side(object.Sphere.center);
            const { radius } = object.Sphere;
            return shape("circle", { cx, cy, r: UNIT * radius, ...look });
        }
        if ("Triangle" in object) {
            return shape("polygon", { points: object.Triangle.corners.map((corner) => side(corner).join(",")).join(" "), ...look });
        }
        const { point, normal } = object.Plane;
        // Where it cuts x = 0: y = c for the lecture's plane, whose normal has no z.
        const y = point[1] + (normal[0] * point[0]) / normal[1];
        const [x1, y1] = side([0, y, 20]);
        const [x2, y2] = side([0, y, -60]);
        return shape("line", { x1, y1, x2, y2, stroke: colour(number), "stroke-width": 3 });
    });
}

export function pixelToRay(stage: HTMLElement): void {
    const svg = drawing(WIDTH, HEIGHT, (x, y) => {
        if (y < n_y * CELL) {
            i.value = clamped(Math.floor(x / CELL), 0, n_x - 1);
            j.value = clamped(n_y - 1 - Math.floor(y / CELL), 0, n_y - 1);
            draw();
        }
    });
    const { i: startI, j: startJ } = facts.slide.pixel;
    const i = slider("column i", [0, n_x - 1, 1], startI, () => draw());
    const j = slider("row j, from the bottom", [0, n_y - 1, 1], startJ, () => draw());
    const numbers = table();
    const still = [...picture(), ...fromTheSide()];

    function draw(): void {
        const ray = viewingRay(camera, { i: i.value, j: j.value }, resolution);
        const hit = firstHit(objects, ray, minT);
        const end = at(ray, hit?.intersection.t ?? 9);
        const [ex, ey] = side(camera.eye);
        const [px, py] = side(end);
        const [sx, sy] = side(at(ray, 1));
        const middle = add(camera.eye, scale(camera.w, facts.slide.forward * -1));
        const [ax, ay] = side(add(middle, scale(camera.v, -2.5)));
        const [bx, by] = side(add(middle, scale(camera.v, 2.5)));
        const chosen = {
            x: i.value * CELL - 1,
            y: (n_y - 1 - j.value) * CELL - 1,
            width: CELL + 1.5,
            height: CELL + 1.5,
            fill: "none",
            stroke: "#ffffff",
            "stroke-width": 3,
        };
        svg.replaceChildren(
            ...still,
            shape("rect", chosen),
            shape("rect", { ...chosen, stroke: "#000000", "stroke-width": 1 }),
            shape("line", { x1: 0, x2: WIDTH, y1: TOP, y2: TOP, stroke: "currentColor", "stroke-opacity": 0.3 }),
            shape("line", { x1: ax, y1: ay, x2: bx, y2: by, stroke: "currentColor", "stroke-width": 3 }),
            shape("line", { x1: ex, y1: ey, x2: px, y2: py, stroke: "#d55e00", "stroke-width": 2 }),
            shape("circle", { cx: ex, cy: ey, r: 4, fill: "currentColor" }),
            shape("circle", { cx: sx, cy: sy, r: 3.5, fill: "currentColor" }),
            shape("circle", { cx: px, cy: py, r: hit === null ? 0 : 5, fill: "#d55e00", stroke: "currentColor" }),
            shape("text", { x: ex - 10, y: ey + 4, fill: "currentColor", "font-size": 15, "text-anchor": "end" }, "e"),
            shape("text", { x: sx + 8, y: sy + 14, fill: "currentColor", "font-size": 13 }, "t = 1"),
            shape("text", { x: 8, y: TOP + 20, fill: "currentColor", "font-size": 13 }, "from the side: z to the left, y up"),
        );
        numbers.show([
            ["pixel", `(${i.value}, ${j.value})`],
            ["u(i)", shown(onPlane(i.value + 0.5, camera.width, n_x))],
            ["v(j)", shown(onPlane(j.value + 0.5, camera.height, n_y))],
            ["e", vector(ray.origin)],
            ["d", vector(ray.direction)],
            ["first hit", hit === null ? "none" : `object ${hit.object}, t = ${shown(hit.intersection.t)}`],
        ]);
    }
    stage.replaceChildren(svg, i.row, j.row, numbers.element);
    draw();
}
