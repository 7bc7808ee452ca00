/**
 * Runs the tests in the browser, three files side by side. They run in real time: a jog has to end when a computer is
 * silent for a quarter of a second, and a busy computer sometimes is. So up to eight files that fail are run once more,
 * one by one, each on a new machine, and what passed only then is told. What is broken fails twice.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";

const vitest = "node_modules/vitest/vitest.mjs";
const mostFiles = 8;
const folder = mkdtempSync(join(tmpdir(), "kerf-browser-"));

/** Whether these files pass, and what failed of them. */
function run(files, ...options) {
  const told = join(folder, "told.json");
  rmSync(told, { force: true });
  const which = ["run", "--config", "vitest.browser.config.ts", "--dir", "tests/browser"];
  const how = ["--reporter=default", "--reporter=json", `--outputFile.json=${told}`];
  const { status } = spawnSync(process.execPath, [vitest, ...which, ...how, ...options, ...files], {
    stdio: "inherit",
  });
  return { passed: status === 0, failed: status === 0 ? [] : failures(told) };
}

function failures(told) {
  const { testResults } = JSON.parse(readFileSync(told, "utf8"));
  return testResults
    .filter(({ status }) => status === "failed")
    .map(({ name, assertionResults }) => ({
      file: name,
      tests: assertionResults
        .filter(({ status }) => status === "failed")
        .map((one) => one.fullName),
    }));
}

const words = ({ file, tests }) => [basename(file), ...tests].join("\n    ");

const first = run(process.argv.slice(2));
let { passed } = first;
if (!passed && first.failed.length > 0 && first.failed.length <= mostFiles) {
  console.log(`Run once more:\n  ${first.failed.map(words).join("\n  ")}`);
  ({ passed } = run(
    first.failed.map(({ file }) => file),
    "--maxWorkers=1",
  ));
  if (passed)
    console.log(`NOT STEADY, passed the second time:\n  ${first.failed.map(words).join("\n  ")}`);
}
rmSync(folder, { recursive: true });
process.exitCode = passed ? 0 : 1;
