// A point dragged over the worked triangle's plane: α, β, and the three conditions.

import facts from "./facts.json";
import { WIDTH, circle, clamped, drawing, line, shape, slider, table, word } from "./stage";
import { shown } from "./words";

type Pair = readonly [number, number];

const { t1, t2, to_weights, start } = facts.triangle_weights as unknown as {
    readonly t1: Pair;
    readonly t2: Pair;
    readonly to_weights: readonly [Pair, Pair];
    readonly start: Pair;
};
const [LEAST, MOST, STEP] = [-0.4, 1.4, 0.05];

// A place in the triangle's plane, from its corner a.
const point = (alpha: number, beta: number): Pair => [
    alpha * t1[0] + beta * t2[0],
    alpha * t1[1] + beta * t2[1],
];
// All places that the sliders reach are on the drawing.
const corners = [point(LEAST, LEAST), point(LEAST, MOST), point(MOST, LEAST), point(MOST, MOST)];
const [left, right] = [Math.min(...corners.map(([x]) => x)), Math.max(...corners.map(([x]) => x))];
const [bottom, top] = [Math.min(...corners.map(([, y]) => y)), Math.max(...corners.map(([, y]) => y))];
const MARGIN = 10;
const SCALE = (WIDTH - 2 * MARGIN) / (right - left);
const HEIGHT = SCALE * (top - bottom) + 2 * MARGIN;
const place = ([x, y]: Pair): Pair => [MARGIN + SCALE * (x - left), MARGIN + SCALE * (top - y)];

export function triangleWeights(stage: HTMLElement): void {
    const svg = drawing(HEIGHT, (atX, atY) => {
        const [x, y] = [(atX - MARGIN) / SCALE + left, top - (atY - MARGIN) / SCALE];
        const [forAlpha, forBeta] = to_weights;
        alpha.value = clamped(forAlpha[0] * x + forAlpha[1] * y, LEAST, MOST);
        beta.value = clamped(forBeta[0] * x + forBeta[1] * y, LEAST, MOST);
        draw();
    });
    const alpha = slider("α", [LEAST, MOST, STEP], start[0], () => draw());
    const beta = slider("β", [LEAST, MOST, STEP], start[1], () => draw());
    const numbers = table();

    function draw(): void {
        // As many digits as the sliders have.
        const [α, β, sum] = [alpha.value, beta.value, alpha.value + beta.value].map((value) => Math.round(value * 100) / 100) as [number, number, number];
        const conditions = [
            ["α ≥ 0", α >= 0],
            ["β ≥ 0", β >= 0],
            ["α + β ≤ 1", sum <= 1],
        ] as const;
        const inside = conditions.every(([, holds]) => holds);
        const [a, b, c, p] = [point(0, 0), point(1, 0), point(0, 1), point(α, β)].map(place) as [Pair, Pair, Pair, Pair];
        const foot = place(point(α, 0));
        svg.replaceChildren(
            shape("polygon", { points: [a, b, c].join(" "), fill: "#56b4e9", "fill-opacity": 0.3, stroke: "currentColor" }),
            line(a, foot, "#d55e00", 3),
            line(foot, p, "#009e73", 3),
            circle(p, 7, inside ? "#d55e00" : "none"),
            word([a[0] - 12, a[1] + 18], "a"),
            word([b[0] + 12, b[1] + 18], "b"),
            word([c[0], c[1] - 12], "c"),
        );
        numbers.show([
            ["α", shown(α)],
            ["β", shown(β)],
            ["α + β", shown(sum)],
            ...conditions.map(([name, holds]) => [name, holds ? "true" : "false"] as const),
        ]);
    }
    stage.replaceChildren(svg, alpha.row, beta.row, numbers.element);
    draw();
}
