// Opens every page of a built edition in a real browser, at desktop and phone width, light
// and dark, and says what is wrong: errors on the console, anything fetched from elsewhere,
// a page wider than the screen, what axe-core finds against WCAG 2.2 AA, a figure that the
// keyboard does not move, a drawing that is illegible (figures.js), and what stays folded on
// paper. With --out it leaves screenshots, to be looked at.
//
//     node look/look.js ../build/student [--out DIR] [--page PATH, or how it begins]

import { existsSync, mkdirSync, readdirSync, readFileSync, statSync } from "node:fs";
import { createRequire } from "node:module";
import { join, relative, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import puppeteer from "puppeteer-core";
import { drawingsWrong, foldedInPrint } from "./figures.js";

const AXE = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa"];
const SCREENS = [
    { name: "desktop", width: 1280, height: 900 },
    { name: "phone", width: 390, height: 844 },
];
const THEMES = ["light", "navy"];
// The only rule about colours, which is the slowest. Colours don't depend on the width, and nothing
// else depends on the theme.
const CONTRAST = "color-contrast";
// Pixels; on the phone a drawing is 350 wide.
const SMALLEST_WORD = 11;
// These are not pages: a frame of links, and the answer to a wrong address.
const OTHER = ["toc.html", "404.html"];

const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { out: { type: "string" }, page: { type: "string" } },
});
const folder = resolve(positionals[0] ?? "../build/student");

const pagesOf = (from) =>
    readdirSync(from).flatMap((name) => {
        const path = join(from, name);
        return statSync(path).isDirectory() ? pagesOf(path) : path.endsWith(".html") ? [path] : [];
    });

const chromium = ["/usr/bin/chromium", "/usr/bin/google-chrome", process.env.CHROMIUM].find(
    (path) => path !== undefined && existsSync(path),
);
if (chromium === undefined) {
    console.error("there is no Chromium\n  remedy: install it, or name it in CHROMIUM");
    process.exit(3);
}

// What axe-core looks for: the contrast of colours, everything else, both, or nothing (null).
function axeRules(colours, others) {
    if (!others) {
        return colours ? { runOnly: { type: "rule", values: [CONTRAST] } } : null;
    }
    return { runOnly: TAGS, rules: { [CONTRAST]: { enabled: colours } } };
}

// Finds what is wrong with a page on the screen.
async function look(page, url, rules) {
    const wrong = [];
    const listen = (message) => message.type() === "error" && wrong.push(`console: ${message.text()}`);
    const failed = (error) => wrong.push(`error: ${error.message}`);
    const asked = (request) => request.url().startsWith("http") && wrong.push(`fetches ${request.url()}`);
    page.on("console", listen).on("pageerror", failed).on("request", asked);
    await page.goto(url, { waitUntil: "load" });
    const wider = await page.evaluate(() => {
        const room = document.documentElement.clientWidth;
        return document.documentElement.scrollWidth > room
            ? [...document.querySelectorAll("main *")]
                  .filter((element) => element.getBoundingClientRect().right > room + 1)
                  .slice(0, 3)
                  .map((element) => element.outerHTML.slice(0, 80))
            : null;
    });
    if (wider !== null) {
        wrong.push(`wider than the screen: ${wider.join(" | ")}`);
    }
    const folded = await page.evaluate(foldedInPrint);
    if (folded > 0) {
        wrong.push(`printing leaves ${folded} parts folded`);
    }
    for (const what of await page.evaluate(drawingsWrong, { smallest: SMALLEST_WORD })) {
        wrong.push(`figure ${what}`);
    }
    await page.evaluate(() => document.querySelectorAll("main details").forEach((one) => (one.open = true)));
    if (rules !== null) {
        await page.addScriptTag({ path: AXE });
        const found = await page.evaluate((wanted) => window.axe.run(document, { ...wanted, preload: false }), rules);
        for (const { id, help, nodes } of found.violations) {
            wrong.push(`axe ${id}: ${help}: ${nodes[0].html.slice(0, 120)} (${nodes.length})`);
        }
    }
    for (const figure of await page.$$("figure[data-figure]")) {
        const name = await figure.evaluate((element) => element.dataset.figure);
        for (const input of await figure.$$("input")) {
            const told = () => figure.$eval("dl", (table) => table.textContent);
            const before = await told();
            await input.focus();
            await page.keyboard.press("ArrowRight");
            if ((await told()) === before || page.url() !== url) {
                wrong.push(`the keyboard does not move the figure ${name}`);
            }
            await page.keyboard.press("ArrowLeft");
        }
    }
    page.off("console", listen).off("pageerror", failed).off("request", asked);
    return wrong;
}

const browser = await puppeteer.launch({
    executablePath: chromium,
    args: ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
let problems = 0;
// A page that has moved leaves a page behind that redirects to its new place.
const leadsOn = (path) => readFileSync(path, "utf8").includes('http-equiv="refresh"');
const chosen = pagesOf(folder).filter((path) => {
    const name = relative(folder, path);
    return !OTHER.includes(name) && !leadsOn(path) && (values.page === undefined || name.startsWith(values.page));
});
for (const { name, width, height } of SCREENS) {
    for (const theme of THEMES) {
        const rules = axeRules(name === SCREENS[0].name, theme === THEMES[0]);
        const page = await browser.newPage();
        await page.setViewport({ width, height });
        await page.evaluateOnNewDocument((wanted) => localStorage.setItem("mdbook-theme", wanted), theme);
        for (const path of chosen) {
            const inside = relative(folder, path);
            for (const what of await look(page, pathToFileURL(path).href, rules)) {
                problems += 1;
                console.log(`${inside}, ${name}, ${theme}: ${what}`);
            }
            if (values.out !== undefined) {
                // Pictures far down load late, but a screenshot needs them all at once.
                await page.$$eval("img", (all) =>
                    Promise.all(all.map((one) => ((one.loading = "eager"), one.decode().catch(() => null)))),
                );
                mkdirSync(values.out, { recursive: true });
                const file = `${inside.replaceAll("/", "-").replace(".html", "")}.${name}.${theme}.png`;
                await page.screenshot({ path: join(values.out, file), fullPage: true });
            }
        }
        await page.close();
    }
}
await browser.close();
console.log(`${chosen.length} pages, ${SCREENS.length * THEMES.length} ways each: ${problems} problems`);
process.exit(problems === 0 ? 0 : 1);
