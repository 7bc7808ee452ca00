/** What comes over HTTP and not over the socket: files, tool paths, the table of commands. */

/** A refusal of the server, in its own words. */
export class Refused extends Error {}

async function get(path: string, signal?: AbortSignal): Promise<Response> {
  const response = await fetch(path, signal ? { signal } : {});
  if (!response.ok) throw new Refused((await response.text()) || response.statusText);
  return response;
}

/** A JSON answer; its type is the one the wire crate gives this address. */
export async function getJson<T>(path: string, signal?: AbortSignal): Promise<T> {
  return (await get(path, signal)).json() as Promise<T>;
}

export const getBytes = async (path: string, signal?: AbortSignal): Promise<ArrayBuffer> =>
  (await get(path, signal)).arrayBuffer();

export const getText = async (path: string, signal?: AbortSignal): Promise<string> =>
  (await get(path, signal)).text();
