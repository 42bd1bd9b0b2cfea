// Equal balls in a row: how high each is on the image plane, for any focal length, and
// orthographically, which is where the slider ends.

import facts from "./facts.json";
import { drawing, shape, slider, table } from "./stage";
import { shown } from "./words";

const [WIDTH, HEIGHT, SCALE, AXIS] = [640, 260, 46, 110];
const RADIUS = 0.8;
// From the image plane, which stays.
const BALLS = [2.5, 5, 7.5];
const PLANE = 200;
const [SHORT, LONG, STEP] = [1, 12, 0.5];
const ORTHOGRAPHIC = LONG + STEP;

// Where the upper line of sight touches a ball, and how high the ball is on the plane.
function seen(ball: number, focal: number): { touch: readonly [number, number]; high: number } {
    if (focal === ORTHOGRAPHIC) {
        return { touch: [ball, RADIUS], high: 2 * RADIUS };
    }
    const sine = RADIUS / (focal + ball);
    const cosine = Math.sqrt(1 - sine * sine);
    const along = (focal + ball) * cosine;
    return { touch: [along * cosine - focal, along * sine], high: (2 * focal * sine) / cosine };
}

export function projections(stage: HTMLElement): void {
    const svg = drawing(WIDTH, HEIGHT, (x) => {
        focal.value = Math.min(ORTHOGRAPHIC, Math.max(SHORT, (PLANE - x) / SCALE));
        draw();
    });
    const focal = slider("focal length; the end is orthographic", [SHORT, ORTHOGRAPHIC, STEP], 2.5, () => draw());
    const numbers = table();
    const x = (along: number): number => PLANE + SCALE * along;
    const line = (x1: number, y1: number, x2: number, y2: number, stroke: string, width: number) =>
        shape("line", { x1, y1, x2, y2, stroke, "stroke-width": width });

    function draw(): void {
        const parts = [line(PLANE, AXIS - 80, PLANE, AXIS + 80, "currentColor", 3)];
        const parallel = focal.value === ORTHOGRAPHIC;
        const rows = BALLS.map((ball, number) => {
            const { touch, high } = seen(ball, focal.value);
            const fill = facts.colours[number] ?? "currentColor";
            const cx = x(ball);
            parts.push(shape("circle", { cx, cy: AXIS, r: SCALE * RADIUS, fill, "fill-opacity": 0.5, stroke: "currentColor" }));
            for (const side of [-1, 1]) {
                const from = parallel ? [PLANE, touch[1]] : [x(-focal.value), 0];
                parts.push(line(from[0] ?? 0, AXIS + side * SCALE * (from[1] ?? 0), x(touch[0]), AXIS + side * SCALE * touch[1], fill, 2));
            }
            // As large as it is in the picture, below.
            parts.push(shape("circle", { cx, cy: HEIGHT - 46, r: (SCALE * high) / 2, fill, stroke: "currentColor" }));
            return [`ball ${number + 1}`, `${shown(high)} high`] as const;
        });
        if (!parallel) {
            parts.push(shape("circle", { cx: x(-focal.value), cy: AXIS, r: 4, fill: "currentColor" }));
        }
        svg.replaceChildren(...parts);
        numbers.show([["projection", parallel ? "orthographic" : `perspective, f = ${shown(focal.value)}`], ...rows]);
    }
    stage.replaceChildren(svg, focal.row, numbers.element);
    draw();
}
