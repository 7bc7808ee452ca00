/** What comes over HTTP and not over the socket: files, tool paths, the table of commands. */

import type { Problem } from "../wire/messages";

/** A refusal of the server, in its own words. */
export class Refused extends Error {
  /** As HTTP has it. */
  readonly status: number;

  constructor(words: string, status: number) {
    super(words);
    this.status = status;
  }
}

async function request(path: string, init: RequestInit): Promise<Response> {
  const response = await fetch(path, init);
  if (!response.ok) throw new Refused(await refusal(response), response.status);
  return response;
}

/** The words of a refusal: those of its problem when it has one. */
async function refusal(response: Response): Promise<string> {
  const text = await response.text();
  try {
    const problem = JSON.parse(text) as Partial<Problem>;
    return problem.text ?? text;
  } catch {
    return text || response.statusText;
  }
}

const get = (path: string, signal?: AbortSignal): Promise<Response> =>
  request(path, signal ? { signal } : {});

/** A JSON answer; its type is the one the wire crate gives this address. */
export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await get(path, signal)).json() as Promise<T>;
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

export async function deleteAt(path: string): Promise<void> {
  await request(path, { method: "DELETE" });
}

const encoded = (name: string): string => name.split("/").map(encodeURIComponent).join("/");

/** The address of a file of the part folder. */
export const fileAddress = (name: string): string => `/api/files/${encoded(name)}`;

/** The address of a sound. */
export const soundAddress = (name: string): string => `/api/media/${encoded(name)}`;

export const readFile = (name: string): Promise<string> => getText(fileAddress(name));

export async function writeFile(name: string, text: string): Promise<void> {
  await request(fileAddress(name), {
    method: "PUT",
    headers: { "content-type": "application/octet-stream" },
    body: text,
  });
}
