// Equal balls in a row, and how high each is on the image plane, for any focal length. At the
// end of the slider, the projection is orthographic.

import facts from "./facts.json";
import { WIDTH, circle, drawing, line, slider, table } from "./stage";
import { shown } from "./words";

const [HEIGHT, AXIS] = [214, 80];
const RADIUS = 0.8;
// The balls' distances from the image plane, which doesn't move.
const BALLS = [2.5, 5, 7.5];
const [SHORT, LONG, STEP] = [1, 8, 0.5];
// With the longest focal length the eye is still on the drawing.
const MARGIN = 10;
const SCALE = (WIDTH - 2 * MARGIN) / (LONG + Math.max(...BALLS) + RADIUS);
const PLANE = MARGIN + SCALE * LONG;
const ORTHOGRAPHIC = LONG + STEP;

// Where the upper line of sight touches a ball, and how high the ball is on the plane.
function seen(ball: number, focal: number): { touch: readonly [number, number]; high: number } {
    if (focal === ORTHOGRAPHIC) {
        return { touch: [ball, RADIUS], high: 2 * RADIUS };
    }
    const angle = Math.asin(RADIUS / (focal + ball));
    const along = (focal + ball) * Math.cos(angle);
    const touch = [along * Math.cos(angle) - focal, along * Math.sin(angle)] as const;
    return { touch, high: 2 * focal * Math.tan(angle) };
}

export function projections(stage: HTMLElement): void {
    const svg = drawing(HEIGHT, (x) => {
        focal.value = Math.min(ORTHOGRAPHIC, Math.max(SHORT, (PLANE - x) / SCALE));
        draw();
    });
    const focal = slider("focal length; the end is orthographic", [SHORT, ORTHOGRAPHIC, STEP], 2.5, () => draw());
    const numbers = table();
    const place = (along: number, up: number): readonly [number, number] => [PLANE + SCALE * along, AXIS - SCALE * up];

    function draw(): void {
        const parts = [line(place(0, 2.5), place(0, -2.5), "currentColor", 3)];
        const parallel = focal.value === ORTHOGRAPHIC;
        const rows = BALLS.map((ball, number) => {
            const { touch, high } = seen(ball, focal.value);
            const [along, up] = touch;
            const fill = facts.colours[number] ?? "currentColor";
            parts.push(circle(place(ball, 0), SCALE * RADIUS, fill, 0.5));
            for (const side of [-1, 1]) {
                const from = parallel ? place(0, side * up) : place(-focal.value, 0);
                parts.push(line(from, place(along, side * up), fill, 2));
            }
            // Below the drawing, the ball is as large as it is in the picture.
            const [x] = place(ball, 0);
            parts.push(circle([x, HEIGHT - 32], (SCALE * high) / 2, fill));
            return [`ball ${number + 1}`, `${shown(high)} high`] as const;
        });
        if (!parallel) {
            parts.push(circle(place(-focal.value, 0), 4, "currentColor"));
        }
        svg.replaceChildren(...parts);
        numbers.show([["projection", parallel ? "orthographic" : `perspective, f = ${shown(focal.value)}`], ...rows]);
    }
    stage.replaceChildren(svg, focal.row, numbers.element);
    draw();
}
