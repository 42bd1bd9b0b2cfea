// A point dragged over the worked triangle's plane: α, β, and the three conditions.

import facts from "./facts.json";
import { type Ray, type Triangle, type Vec, add, scale, sub, weights } from "./rays";
import { clamped, drawing, shape, slider, table } from "./stage";
import { shown } from "./words";

const triangle = facts.worked.triangle as unknown as Triangle;
const worked = facts.worked.ray as unknown as Ray;
const start = weights(triangle, worked);

const [a, b, c] = triangle.corners;
const [t1, t2] = [sub(b, a), sub(c, a)];
const [WIDTH, HEIGHT, SCALE] = [640, 360, 78];

// The triangle lies in a plane z = constant.
const place = ([x, y]: Vec): readonly [number, number] => [150 + SCALE * (x - a[0]), 270 - SCALE * (y - a[1])];
const point = (alpha: number, beta: number): Vec => add(a, add(scale(t1, alpha), scale(t2, beta)));
// The ray that is at this point where the worked one is at its own.
const through = (p: Vec): Ray => ({
    origin: worked.origin,
    direction: scale(sub(p, worked.origin), 1 / start.t),
});

export function triangleWeights(stage: HTMLElement): void {
    const svg = drawing(WIDTH, HEIGHT, (x, y) => {
        const p: Vec = [a[0] + (x - 150) / SCALE, a[1] - (y - 270) / SCALE, a[2]];
        const dragged = weights(triangle, through(p));
        alpha.value = clamped(dragged.alpha, -0.4, 1.4);
        beta.value = clamped(dragged.beta, -0.4, 1.4);
        draw();
    });
    const alpha = slider("α", [-0.4, 1.4, 0.05], start.alpha, () => draw());
    const beta = slider("β", [-0.4, 1.4, 0.05], start.beta, () => draw());
    const numbers = table();

    function draw(): void {
        const p = point(alpha.value, beta.value);
        const found = weights(triangle, through(p));
        // As many digits as the sliders have: theirs are multiples of 0.05.
        const [α, β] = [found.alpha, found.beta].map((value) => Math.round(value * 1e6) / 1e6) as [number, number];
        const inside = α >= 0 && β >= 0 && α + β <= 1;
        const [ax, ay] = place(a);
        const [x1, y1] = place(point(α, 0));
        const [px, py] = place(p);
        const line = (x: number, y: number, toX: number, toY: number, stroke: string) =>
            shape("line", { x1: x, y1: y, x2: toX, y2: toY, stroke, "stroke-width": 3 });
        const word = ([x, y]: readonly [number, number], text: string) =>
            shape("text", { x: x - 12, y: y + 18, fill: "currentColor", "font-size": 16, "font-weight": "bold" }, text);
        const corners = [a, b, c].map((corner) => place(corner).join(",")).join(" ");
        svg.replaceChildren(
            shape("polygon", { points: corners, fill: "#56b4e9", "fill-opacity": 0.3, stroke: "currentColor" }),
            line(ax, ay, x1, y1, "#0072b2"),
            line(x1, y1, px, py, "#009e73"),
            shape("circle", { cx: px, cy: py, r: 7, fill: inside ? "#d55e00" : "none", stroke: "currentColor", "stroke-width": 2 }),
            word(place(a), "a"),
            word(place(b), "b"),
            word(place(c), "c"),
        );
        const told = (holds: boolean) => (holds ? "true" : "false");
        numbers.show([
            ["α", shown(α)],
            ["β", shown(β)],
            ["α + β", shown(α + β)],
            ["α ≥ 0", told(α >= 0)],
            ["β ≥ 0", told(β >= 0)],
            ["α + β ≤ 1", told(α + β <= 1)],
            ["answer", inside ? `t = ${shown(found.t)}` : "None"],
        ]);
    }
    stage.replaceChildren(svg, alpha.row, beta.row, numbers.element);
    draw();
}
