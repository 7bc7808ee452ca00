/** Fetches over HTTP what does not come over the socket: files, tool paths, the table of commands. */

import type { Problem, TextDraft } from "../wire/messages";
import { t } from "../words/words";

/** A refusal of the server, in its own words. */
export class Refused extends Error {
  readonly problem: Problem;
  /** As HTTP has it. */
  readonly status: number;

  constructor(problem: Problem, status: number) {
    super(problem.text);
    this.problem = problem;
    this.status = status;
  }
}

/** No content: something newer has taken the place of what was asked for, and the socket tells of it. */
export class Outdated extends Error {
  constructor() {
    super(t("This changed meanwhile; try again."));
  }
}

async function request(path: string, init: RequestInit): Promise<Response> {
  const response = await fetch(path, init);
  if (!response.ok) {
    throw new Refused(problemOf(await response.text(), response.statusText), response.status);
  }
  return response;
}

/** Problem in the body of a refusal, or the words of its status where it holds none. */
export function problemOf(text: string, otherwise: string): Problem {
  try {
    const problem = JSON.parse(text) as Partial<Problem>;
    return { why: problem.why ?? "server", text: problem.text ?? text };
  } catch {
    return { why: "server", text: text || otherwise };
  }
}

const get = (path: string, signal?: AbortSignal): Promise<Response> =>
  request(path, signal ? { signal } : {});

/** A JSON answer; its type is the one the wire crate gives this address. Fails with `Outdated` where there is none. */
export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  const response = await get(path, signal);
  if (response.status === 204) throw new Outdated();
  return response.json() as Promise<T>;
}

export const getBytes = async (path: string, signal?: AbortSignal): Promise<ArrayBuffer> =>
  (await get(path, signal)).arrayBuffer();

export const getText = async (path: string, signal?: AbortSignal): Promise<string> =>
  (await get(path, signal)).text();

/** Asks with a body; the answer is JSON. */
export async function postJson<T>(path: string, body: unknown): Promise<T> {
  const headers = { "content-type": "application/json" };
  const response = await request(path, { method: "POST", headers, body: JSON.stringify(body) });
  return response.json() as Promise<T>;
}

/** Puts a JSON value in the place of what lies there. */
export async function putJson(path: string, body: unknown): Promise<void> {
  const headers = { "content-type": "application/json" };
  await request(path, { method: "PUT", headers, body: JSON.stringify(body) });
}

/** Puts plain text in the place of what lies there. */
export async function putText(path: string, text: string): Promise<void> {
  await request(path, { method: "PUT", body: text });
}

export async function deleteAt(path: string, headers: Record<string, string> = {}): Promise<void> {
  await request(path, { method: "DELETE", headers });
}

const encoded = (name: string): string => name.split("/").map(encodeURIComponent).join("/");

/** The address of a file of the part folder. */
export const fileAddress = (name: string): string => `/api/files/${encoded(name)}`;

/** The address of a sound. */
export const soundAddress = (name: string): string => `/api/media/${encoded(name)}`;

/** Text of a file, and the hash of that content. */
export interface Content {
  readonly text: string;
  readonly hash: string;
}

/** The hash that an answer carries as its entity tag. */
const hashOf = (response: Response): string =>
  response.headers.get("etag")?.replaceAll('"', "") ?? "";

/** The bytes of a file, and the hash that says which content it was. */
export async function readBytes(address: string): Promise<{ bytes: ArrayBuffer; hash: string }> {
  const response = await get(address);
  return { bytes: await response.arrayBuffer(), hash: hashOf(response) };
}

export async function readFile(name: string): Promise<Content> {
  const response = await get(fileAddress(name));
  return { text: await response.text(), hash: hashOf(response) };
}

/** Writes a file, in the place of the one with this hash where there is one; gives the hash it has now. */
export async function writeFile(
  name: string,
  text: string | Blob,
  replaces: string | null,
): Promise<string> {
  const headers = writingOver(replaces);
  const response = await request(fileAddress(name), { method: "PUT", headers, body: text });
  return hashOf(response);
}

const plain = { "content-type": "application/octet-stream" };

/** Headers of a write, in the place of the file with this hash where there is one. */
const writingOver = (replaces: string | null): Record<string, string> =>
  replaces ? { ...plain, "if-match": `"${replaces}"` } : plain;

/** Writes a copy of a file; gives why nothing was written. */
export async function copyFile(
  name: string,
  to: string,
  replaces: string | null,
): Promise<Problem | null> {
  try {
    const body = await getBytes(fileAddress(name));
    await request(fileAddress(to), { method: "PUT", headers: writingOver(replaces), body });
    return null;
  } catch (error) {
    if (error instanceof Refused) return error.problem;
    throw error;
  }
}

/** Moves the file with this hash into the bin. */
export const deleteFile = (name: string, hash: string, renamed?: string): Promise<void> => {
  const goes = renamed === undefined ? "" : `?renamed=${encodeURIComponent(renamed)}`;
  return deleteAt(`${fileAddress(name)}${goes}`, { "if-match": `"${hash}"` });
};

/** Takes a file out of the bin, for good. */
export const forgetFile = (name: string): Promise<void> => deleteAt(`${fileAddress(name)}?forget`);

/** Brings an earlier content of a file back. */
export async function restoreFile(name: string, number: number): Promise<void> {
  await request(`${fileAddress(name)}?restore=${number}`, { method: "POST" });
}

/**
 * Keeps text that is not saved; the page may go meanwhile when it is short. Tells whether another page types into the
 * same file.
 */
export async function keepDraft(draft: TextDraft, goes = false): Promise<boolean> {
  const response = await request("/api/texts", {
    method: "PUT",
    headers: { "content-type": "application/json" },
    body: JSON.stringify(draft),
    keepalive: goes,
  });
  return response.json() as Promise<boolean>;
}

/** The address of a file as it was when somebody began to type into it. */
export const baseAddress = (hash: string): string => `/api/texts?base=${hash}`;

/** Ends the draft of a page; with a revision only where it is that text still. */
export function endDraft(name: string, page: string, revision?: string): Promise<void> {
  const of = new URLSearchParams({ name, page, ...(revision ? { revision } : {}) });
  return deleteAt(`/api/texts?${of}`);
}
