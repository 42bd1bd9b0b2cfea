// A sphere that recedes while the lens follows: what three computations make of its picture.

import facts from "./facts.json";
import { SIDE, WAYS, silhouette, wrong } from "./silhouette";
import { slider, table } from "./stage";

const NAMES = { f32: "textbook, f32", f64: "textbook, f64", foot: "stable, f64" } as const;

const rgb = (hex: string): readonly number[] => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));

export function breakingDistance(stage: HTMLElement): void {
    const row = document.createElement("div");
    row.className = "silhouettes";
    row.setAttribute("aria-hidden", "true");
    const ways = (Object.keys(WAYS) as (keyof typeof WAYS)[]).map((way) => {
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [SIDE, SIDE];
        row.append(canvas);
        return { way, canvas };
    });
    const distance = slider("distance / radius, as a power of ten", [1, 12, 0.25], 8, () => draw());
    const numbers = table();
    const [inside, outside] = [rgb(facts.colours[1] ?? "#ffffff"), rgb(facts.background)];

    function draw(): void {
        const far = 10 ** distance.value;
        for (const { way, canvas } of ways) {
            const picture = new ImageData(SIDE, SIDE);
            silhouette(WAYS[way], far).forEach((met, at) => {
                picture.data.set([...(met ? inside : outside), 255], 4 * at);
            });
            canvas.getContext("2d")?.putImageData(picture, 0, 0);
        }
        const told = ways.map(({ way }) => [NAMES[way], `${wrong(WAYS[way], far)} wrong pixels`] as const);
        numbers.show([["distance", far.toPrecision(3)], ...told]);
    }
    stage.replaceChildren(row, distance.row, numbers.element);
    draw();
}
