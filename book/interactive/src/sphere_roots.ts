// A ray moved across a sphere: the discriminant, both roots, and which of them counts.

import facts from "./facts.json";
import { type Ray, type Sphere, type Vec, add, at, countingRoot, dot, length, quadratic, scale, sub } from "./rays";
import { clamped, drawing, shape, slider, table } from "./stage";
import { shown } from "./words";

const sphere = facts.worked.sphere as unknown as Sphere;
const worked = facts.worked.ray as unknown as Ray;

// The plane of the drawing: along the ray, and from the ray to the sphere's centre.
const stride = length(worked.direction);
const along = scale(worked.direction, 1 / stride);
const toCenter = sub(sphere.center, worked.origin);
const ahead = dot(toCenter, along);
const aside = sub(toCenter, scale(along, ahead));
const start = length(aside);
const across = scale(aside, 1 / start);

const [WIDTH, HEIGHT, SCALE] = [640, 300, 66];
const [EYE_X, CENTER_Y] = [60, 150];

// The same ray, passing the centre at this distance; the first is the worked one.
const moved = (distance: number): Ray => ({
    origin: add(worked.origin, scale(across, start - distance)),
    direction: worked.direction,
});

const place = (p: Vec): readonly [number, number] => {
    const from = sub(p, sphere.center);
    return [EYE_X + SCALE * (dot(from, along) + ahead), CENTER_Y - SCALE * dot(from, across)];
};

export function sphereRoots(stage: HTMLElement): void {
    const svg = drawing(WIDTH, HEIGHT, (_, y) => {
        distance.value = clamped((y - CENTER_Y) / SCALE, -2, 2);
        draw();
    });
    const distance = slider("distance of the ray from the centre", [-2, 2, 0.01], start, () => draw());
    const minT = slider("min_t", [0, 3, 0.01], 1, () => draw());
    const numbers = table();

    function draw(): void {
        // A slider rounds; where it still stands at the start, so does the ray.
        const wanted = Math.abs(distance.value - start) < 0.005 ? start : distance.value;
        const ray = moved(wanted);
        const { a, h, k, discriminant, roots } = quadratic(ray, sphere);
        const counts = countingRoot(roots, minT.value);
        const [cx, cy] = place(sphere.center);
        const [ex, ey] = place(ray.origin);
        const [mx] = place(at(ray, minT.value));
        const line = (x1: number, y1: number, x2: number, y2: number, colour: string, width: number, dash = "none") =>
            shape("line", { x1, y1, x2, y2, stroke: colour, "stroke-width": width, "stroke-dasharray": dash });
        const word = (x: number, y: number, text: string) =>
            shape("text", { x, y, fill: "currentColor", "font-size": 16, "text-anchor": "middle" }, text);
        const parts = [
            shape("circle", { cx, cy, r: sphere.radius * SCALE, fill: "#56b4e9", "fill-opacity": 0.3, stroke: "currentColor" }),
            line(ex, ey, mx, ey, "currentColor", 1, "5 4"),
            line(mx, ey, WIDTH - 8, ey, "#d55e00", 2.5),
            line(mx, ey - 14, mx, ey + 14, "#0072b2", 4),
            word(mx, ey + 32, "min_t"),
            shape("circle", { cx: ex, cy: ey, r: 4, fill: "currentColor" }),
            word(ex, ey - 10, "e"),
        ];
        roots?.forEach((t, number) => {
            const [x, y] = place(at(ray, t));
            const fill = counts === number ? "#d55e00" : "none";
            parts.push(shape("circle", { cx: x, cy: y, r: 6, fill, stroke: "currentColor", "stroke-width": 1.5 }));
            parts.push(word(x, y - 12, number === 0 ? "t₀" : "t₁"));
        });
        svg.replaceChildren(...parts);
        const answer = roots === null || counts === null ? "None" : `t${"₀₁"[counts]} = ${shown(roots[counts])}`;
        numbers.show([
            ["a", shown(a)],
            ["h", shown(h)],
            ["k", shown(k)],
            ["Δ", shown(discriminant)],
            ["t₀, t₁", roots === null ? "none: Δ < 0" : roots.map(shown).join(", ")],
            ["min_t", shown(minT.value)],
            ["answer", answer],
        ]);
    }
    stage.replaceChildren(svg, distance.row, minT.row, numbers.element);
    draw();
}
