// The page in a real browser: numbers, sliders, files, addresses, the keyboard, a phone, and how long a step takes.

import assert from "node:assert/strict";
import { createReadStream, existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { createServer } from "node:http";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { extname, join } from "node:path";
import { after, before, test } from "node:test";

import { carvallo, dist, packages, single } from "./command.mjs";

const { chromium } = createRequire(packages)("playwright-core");
const FLAGS = ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/** A server of files and nothing else. */
const server = createServer(({ url }, response) => {
  const path = join(dist, new URL(url, "http://page").pathname.replace(/\/$/, "/index.html"));
  if (!existsSync(path)) return response.writeHead(404).end();
  response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "text/plain" });
  createReadStream(path).pipe(response);
});

let browser;
let profile;
let address;
let faults;

before(async () => {
  profile = mkdtempSync(join(tmpdir(), "carvallo-page-"));
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  address = `http://127.0.0.1:${server.address().port}/`;
  browser = await chromium.launchPersistentContext(profile, { executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS, acceptDownloads: true });
});

after(async () => {
  await browser?.close();
  server.close();
  rmSync(profile, { recursive: true, force: true });
});

/** The page at an address, when it is ready. Whatever it says on the console of faults is collected. */
async function open(hash = "", url = address, size = { width: 1400, height: 1000 }) {
  const page = await browser.newPage();
  await page.setViewportSize(size);
  faults = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(message.text()));
  page.on("pageerror", (error) => faults.push(error.stack));
  await page.goto(url + hash);
  await page.waitForSelector("body[data-ready]");
  return page;
}

async function close(page) {
  assert.deepEqual(faults, []);
  await page.close();
}

const values = (page, id) => page.$$eval(`#${id} td`, (cells) => cells.map((cell) => Number(cell.dataset.value)));
const drawn = (page, id) => page.$eval(`#${id} .drawing`, (element) => element.innerHTML);
const settled = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => setTimeout(done))));
const error = (page) => page.textContent("#error");

test("numbers are those of the command line", async () => {
  const page = await open("#design=Whipple,pista,w:102%20cm&speed=5");
  const analyzed = JSON.parse(carvallo("analyze", "pista", "--set", "w=102 cm", "--speeds", "5", "--format", "json"));
  assert.deepEqual(await values(page, "critical"), analyzed.critical_speeds.map(({ speed }) => speed));
  assert.deepEqual(await values(page, "at-speed"), analyzed.eigenvalues[0].values.flatMap(({ re, im }) => [re, im]));
  await close(page);
});

test("every figure is there, with labels and a grid", async () => {
  const page = await open();
  for (const id of ["eigenvalues", "locus", "motion"]) {
    assert.ok((await page.$$(`#${id} .curve`)).length > 2, id);
    assert.ok((await page.getAttribute(`#${id} .grid`, "d")).split("M").length > 6, id);
    assert.ok((await page.$$(`#${id} text.label`)).length >= 2, id);
  }
  const names = await page.$$eval("#eigenvalues .legend li", (items) => items.map((item) => item.textContent));
  for (const name of ["weave, real part", "capsize", "castering"]) assert.ok(names.includes(name), `${name} in ${names}`);
  assert.match(await page.getAttribute("#side svg", "aria-label"), /wheel base 1\.02 m, trail 0\.08 m, head angle 72°/);
  assert.match(await page.textContent("#stable"), /benchmark: Stable from 4\.29238 to 6\.02426 m\/s\./);
  await close(page);
});

test("a slider moves every picture, and the field and the address follow", async () => {
  const page = await open();
  const before = await Promise.all(["side", "eigenvalues", "locus", "motion", "numbers"].map((id) => drawn(page, id)));
  await page.fill("#p-w", "1.2");
  await settled(page);
  const now = await Promise.all(["side", "eigenvalues", "locus", "motion", "numbers"].map((id) => drawn(page, id)));
  before.forEach((picture, index) => assert.notEqual(picture, now[index]));
  assert.equal(await page.inputValue("#p-w-field"), "1.2");
  await page.waitForFunction(() => location.hash.includes("w:1.2"));
  const expected = JSON.parse(carvallo("analyze", "--set", "w=1.2", "--format", "json")).critical_speeds.map(({ speed }) => speed);
  assert.deepEqual(await values(page, "critical"), expected);
  await page.click("#p-w ~ .reset");
  await settled(page);
  assert.equal(await page.inputValue("#p-w-field"), "1.02");
  assert.equal(await page.inputValue("#p-w"), "1.02");
  await close(page);
});

/** What stands in the drawings, whatever the order of attributes. */
const trees = (page) => page.$$eval(".drawing", (elements) => {
  const tree = (node) => node.nodeType === Node.TEXT_NODE ? node.data
    : [node.namespaceURI, node.localName, [...node.attributes].map(({ name, value }) => `${name}=${value}`).sort(), [...node.childNodes].map(tree)];
  return elements.map(tree);
});

test("after many changes everything is drawn as from nothing, and what did not change was left alone", async () => {
  const page = await open("#design=Whipple,pista");
  await page.$eval("#eigenvalues svg", (element) => (element.dataset.first = ""));
  const steps = [["#p-w", "1.2"], ["#p-lam", "60"], ["#p-mB", "40"], ["#p-w", "0.9"], ["#speed", "2"], ["#p-zB", "-1.4"], ["#speed", "7"], ["#p-c", "-0.02"]];
  for (const [slider, value] of steps) {
    await page.$eval(slider, (element, to) => {
      element.value = to;
      element.dispatchEvent(new Event("input"));
    }, value);
    await settled(page);
  }
  assert.equal(await page.getAttribute("#eigenvalues svg", "data-first"), "");
  await page.$eval("#eigenvalues svg", (element) => delete element.dataset.first);
  await page.click("#add");
  await page.fill("#p-w", "1.1");
  await settled(page);
  await page.click("[data-tab='0']");
  await page.click("#share");
  const fresh = await browser.newPage();
  await fresh.setViewportSize({ width: 1400, height: 1000 });
  await fresh.goto(await page.inputValue("#address"));
  await fresh.waitForSelector("body[data-ready]");
  assert.deepEqual(await trees(page), await trees(fresh));
  // Alone again, and another model: what is too much goes.
  await page.click("[data-close='1']");
  const other = await page.$$eval("#base option", (options) => options.find(({ value }) => value.includes("RearSteered")).value);
  await page.selectOption("#base", other);
  await settled(page);
  await page.click("#share");
  await fresh.goto("about:blank");
  await fresh.goto(await page.inputValue("#address"));
  await fresh.waitForSelector("body[data-ready]");
  assert.deepEqual(await trees(page), await trees(fresh));
  await fresh.close();
  await close(page);
});

test("the head angle is 90 degrees minus the tilt", async () => {
  const page = await open();
  await page.fill("#p-lam-field", "70");
  await page.press("#p-lam-field", "Enter");
  await settled(page);
  const expected = JSON.parse(carvallo("analyze", "--set", "lam=20 deg", "--format", "json")).critical_speeds.map(({ speed }) => speed);
  assert.deepEqual(await values(page, "critical"), expected);
  await close(page);
});

test("the keyboard alone changes a parameter", async () => {
  const page = await open();
  await page.focus("#p-w");
  await page.keyboard.press("ArrowRight");
  await settled(page);
  assert.ok(Number(await page.inputValue("#p-w-field")) > 1.02);
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "p-w-field");
  await page.keyboard.type("1.1");
  await page.keyboard.press("Enter");
  await page.focus("#tabs button");
  for (let presses = 0; presses < 20 && (await page.evaluate(() => document.activeElement.id)) !== "share"; presses++) await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  assert.match(await page.inputValue("#address"), /w:/);
  await close(page);
});

test("an address has all of the designs in it", async () => {
  const page = await open("#design=Whipple,pista");
  await page.fill("#p-w", "1.1");
  await settled(page);
  await page.click("#add");
  await page.selectOption("#base", { label: await page.$eval("#base option[value*='browser-jason']", (option) => option.textContent) });
  await page.setInputFiles("#file", { name: "own, with: signs & more.toml", mimeType: "text/plain", buffer: Buffer.from(carvallo("show", "silver", "--set", "c=5 cm")) });
  await page.waitForFunction(() => document.querySelectorAll("#tabs .tab").length === 3);
  assert.equal(await error(page), "");
  await page.click("#share");
  const [shared, numbers, tabs] = [await page.inputValue("#address"), await drawn(page, "numbers"), await page.textContent("#tabs")];
  const other = await open("", shared);
  assert.equal(await drawn(other, "numbers"), numbers);
  assert.equal(await other.textContent("#tabs"), tabs);
  assert.ok((await other.$$("#eigenvalues .curve.beside")).length > 0);
  await page.close();
  await close(other);
});

test("bad files, values and addresses say so, and the page goes on", async () => {
  const page = await open();
  const file = (name, contents) => page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(contents) });
  await file("bad.toml", "w = 1\nc = hello\n");
  await page.waitForSelector("#error:not([hidden])");
  assert.match(await error(page), /bad\.toml:2: `c` is `hello`; expected a number/);
  await file("picture.toml", Buffer.from([0xff, 0xfe, 0x00]));
  await page.waitForFunction(() => document.getElementById("error").textContent.includes("picture.toml: this is not UTF-8 text"));
  await page.fill("#p-w-field", "-1");
  await page.press("#p-w-field", "Enter");
  await settled(page);
  assert.match(await error(page), /`w` is -1 m; it must be > 0/);
  assert.equal(await page.getAttribute("#p-w-field", "aria-invalid"), "true");
  await page.fill("#p-w-field", "1.05 m");
  await page.press("#p-w-field", "Enter");
  await settled(page);
  assert.equal(await error(page), "");
  await page.fill("#initial", "phi_rat=1");
  await page.press("#initial", "Enter");
  await settled(page);
  assert.match(await page.textContent("#motion-error"), /did you mean `phi_rate`\?/);
  await page.evaluate(() => { location.hash = "#colour=red"; });
  await page.waitForFunction(() => document.getElementById("error").textContent.includes("`colour=red`"));
  await close(page);
});

test("a law of feedback closes the loop, in the address and in the files too", async () => {
  const law = "Tdelta = 10*(4.7 - v)*phi_rate";
  const page = await open("#design=Whipple,benchmark&speed=3");
  await page.click("#add");
  await page.fill("#feedback", law);
  await page.press("#feedback", "Enter");
  await settled(page);
  const closed = JSON.parse(carvallo("analyze", "--feedback", law, "--speeds", "3", "--format", "json"));
  assert.deepEqual(await values(page, "critical"), closed.critical_speeds.map(({ speed }) => speed));
  assert.deepEqual(await values(page, "at-speed"), closed.eigenvalues[0].values.flatMap(({ re, im }) => [re, im]));
  const [[from]] = closed.stable_ranges;
  assert.match(await page.textContent("#stable"), new RegExp(`benchmark with feedback: Stable from ${Number(from.toPrecision(6))} `));
  // The open loop lies below it, and the force has a graph.
  assert.ok((await page.$$("#eigenvalues .curve.beside")).length > 0);
  const graphs = await page.$$eval("#motion svg[role=img]", (graphs) => graphs.map((graph) => graph.getAttribute("aria-label")));
  assert.ok(graphs.some((label) => label.startsWith("torques (N m)")), graphs);
  await page.waitForFunction(() => location.hash.includes("feedback:Tdelta"));
  const [loaded] = await Promise.all([page.waitForEvent("download"), page.click('[data-file="json"]')]);
  assert.equal(readFileSync(await loaded.path(), "utf8"), carvallo("analyze", "--feedback", law, "--format", "json"));
  const other = await open("", page.url());
  assert.equal(await other.inputValue("#feedback"), law);
  assert.equal(await drawn(other, "numbers"), await drawn(page, "numbers"));
  await other.fill("#feedback", "Tdelt = phi");
  await other.press("#feedback", "Enter");
  await settled(other);
  assert.match(await error(other), /`Tdelt` is no force on Whipple; did you mean `Tdelta`\?/);
  assert.equal(await other.getAttribute("#feedback", "aria-invalid"), "");
  await other.click("#open-loop");
  await settled(other);
  assert.equal(await error(other), "");
  assert.equal(await other.inputValue("#feedback"), "");
  assert.match(await other.textContent("#stable"), /benchmark: Stable from 4\.29238/);
  await page.close();
  await close(other);
});

test("a file that is dropped is shown", async () => {
  const page = await open();
  const text = carvallo("show", "rigid");
  await page.evaluate((text) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([text], "dropped.toml"));
    document.dispatchEvent(new DragEvent("drop", { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, text);
  await page.waitForFunction(() => document.getElementById("status").textContent.includes("dropped.toml"));
  const expected = JSON.parse(carvallo("analyze", "rigid", "--format", "json")).critical_speeds.map(({ speed }) => speed);
  assert.deepEqual(await values(page, "critical"), expected);
  await close(page);
});

test("designs are kept, and forgotten", async () => {
  const page = await open();
  await page.fill("#p-c", "0.1");
  await page.fill("#name", "my own");
  await page.press("#name", "Enter");
  await page.waitForFunction(() => location.hash.includes("file=my%20own"));
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  assert.ok(await page.$("#base optgroup[label='Kept in this browser'] option"));
  await page.click("#forget");
  assert.equal(await page.$("#base optgroup[label='Kept in this browser'] option"), null);
  await close(page);
});

test("downloads are the files of the command line, and pictures that other programs read", async () => {
  const page = await open("#design=Whipple,pista");
  const download = async (file) => {
    const [loaded] = await Promise.all([page.waitForEvent("download"), page.click(`[data-file="${file}"]`)]);
    return [loaded.suggestedFilename(), readFileSync(await loaded.path(), "utf8")];
  };
  assert.deepEqual(await download("toml"), ["pista.toml", carvallo("show", "pista")]);
  assert.deepEqual(await download("json"), ["pista.json", carvallo("analyze", "pista", "--format", "json")]);
  assert.deepEqual(await download("csv"), ["pista.csv", carvallo("analyze", "pista", "--format", "csv")]);
  for (const id of ["eigenvalues", "side", "locus", "motion"]) {
    const [name, svg] = await download(`${id} svg`);
    assert.equal(name, `pista-${id}.svg`);
    const read = await page.evaluate((svg) => new DOMParser().parseFromString(svg, "image/svg+xml").documentElement.nodeName, svg);
    assert.equal(read, "svg");
    assert.ok(!svg.includes("var(") && !svg.includes("color("), id);
  }
  await close(page);
});

test("on a phone nothing is wider than it", async () => {
  for (const width of [320, 375]) {
    const page = await open("#design=Whipple,pista&design=WhippleMechanism,benchmark", address, { width, height: 700 });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), width);
    await close(page);
  }
});

test("every model and set that can be chosen is shown", async () => {
  const page = await open();
  const options = await page.$$eval("#base option", (options) => options.map((option) => option.value));
  for (const option of options) {
    await page.selectOption("#base", option);
    await settled(page);
    assert.equal(await error(page), "", option);
    assert.equal(await page.isHidden("#motion-error"), true, option);
    assert.ok(!(await page.innerHTML("main")).includes("NaN"), option);
  }
  await close(page);
});

test("as one file it opens without a server", async () => {
  const page = await open("", `file://${single}`);
  assert.match(await page.textContent("#stable"), /Stable from 4\.29238/);
  await close(page);
});

test("each step of a slider draws within its frame", async (context) => {
  const page = await open("#design=Whipple,pista");
  const { times, pictures } = await page.evaluate(async () => {
    const slider = document.getElementById("p-w");
    const times = [];
    const pictures = new Set();
    for (let step = 0; step < 100; step++) {
      // The page draws in the next frame, between these two; the layout, which reading a size waits for, belongs to it.
      let start;
      requestAnimationFrame(() => (start = performance.now()));
      slider.value = 0.8 + 0.005 * step;
      slider.dispatchEvent(new Event("input"));
      times.push(await new Promise((done) => requestAnimationFrame(() => {
        void document.body.offsetHeight;
        done(performance.now() - start);
      })));
      pictures.add(document.querySelector("#side svg").outerHTML);
    }
    return { times: times.sort((a, b) => a - b), pictures: pictures.size };
  });
  // How long a frame takes is told and not asked for, since other programs run on the machine as well.
  context.diagnostic(`median ${times[50].toFixed(1)} ms, worst ${times[99].toFixed(1)} ms`);
  assert.equal(pictures, 100);
  await close(page);
});
