// Writes numbers as the book and `explain` do.

export function shown(value: number): string {
    const digits = Number(value.toPrecision(6));
    const text = Object.is(digits, -0) ? "0" : String(digits);
    return text.replace(/-/g, "−");
}
