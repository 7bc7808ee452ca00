import { expect, it } from "vitest";
import { states } from "../../tests/standin/states";
import type { Snapshot } from "../wire/messages";
import { newsOf } from "./notify";

type Told = Pick<Snapshot, "job" | "asked">;
const job = states.running?.job as NonNullable<Snapshot["job"]>;
const asked = states.asking?.asked as NonNullable<Snapshot["asked"]>;
const runs: Told = { job, asked: null };
const ended = (how: string): Told => ({ job: { ...job, ended: how }, asked: null });

it.each<[Told, Told, string | undefined]>([
  [runs, runs, undefined],
  [runs, { job, asked }, `${job.file} needs you: ${asked.text}`],
  [{ job, asked }, { job, asked }, undefined],
  [runs, ended("ok"), `${job.file} is done`],
  [ended("ok"), ended("ok"), undefined],
  [runs, ended("stopped"), `${job.file} failed: stopped`],
  [runs, { job: { ...job, ended: "ok", command: "MX,1" }, asked: null }, undefined],
])("%#", (before, now, text) => expect(newsOf(before, now)).toBe(text));
