/** A link that can be made bad: a proxy between a page and its server that loses, delays or doubles messages. */

import { createServer, connect as dial, type Socket } from "node:net";

/** Fate of a message: the number of copies that go on, and their delay. */
export interface Fate {
  readonly copies: number;
  readonly afterMs: number;
}

export const asUsual: Fate = { copies: 1, afterMs: 0 };

export interface RoughLink {
  /** Address to which pages connect. */
  readonly address: string;
  /** Decides about each message of a page. */
  fromPage: (text: string) => Fate;
  /** Decides about each message of the server. */
  fromServer: (text: string) => Fate;
  /** Every message of a page so far, with the moment when it came. */
  readonly heard: { readonly text: string; readonly atMs: number }[];
  /** Sends a message of a page once more, exactly as it was. */
  again(text: string): void;
  close(): void;
}

/** A frame of a WebSocket: its bytes as they came, and its text when it has one. */
interface Frame {
  readonly bytes: Buffer;
  readonly text: string;
}

/** Cuts a stream of bytes into frames; what is not a whole frame yet waits. */
class Frames {
  #rest: Buffer = Buffer.alloc(0);

  take(more: Buffer): Frame[] {
    this.#rest = Buffer.concat([this.#rest, more]);
    const frames: Frame[] = [];
    for (let frame = this.#next(); frame; frame = this.#next()) frames.push(frame);
    return frames;
  }

  #next(): Frame | undefined {
    const all = this.#rest;
    const { head, length } = sizes(all);
    if (all.length < head + length) return undefined;
    const bytes = Buffer.from(all.subarray(0, head + length));
    this.#rest = Buffer.from(all.subarray(head + length));
    return { bytes, text: textOf(bytes, head) };
  }
}

/** Length of a frame's head and of its content; endless when that is not known yet. */
function sizes(all: Buffer): { head: number; length: number } {
  const notYet = { head: 0, length: Number.POSITIVE_INFINITY };
  const [, second] = all;
  if (second === undefined) return notYet;
  const short = second & 0x7f;
  const wide = short === 126 ? 2 : short === 127 ? 8 : 0;
  const head = 2 + wide + (second & 0x80 ? 4 : 0);
  if (all.length < head) return notYet;
  if (wide === 0) return { head, length: short };
  return { head, length: wide === 2 ? all.readUInt16BE(2) : Number(all.readBigUInt64BE(2)) };
}

/** The text of a frame; nothing for pings and the like. Pages mask what they send. */
function textOf(bytes: Buffer, head: number): string {
  const [first = 0, second = 0] = bytes;
  if ((first & 0x0f) !== 1) return "";
  const mask = second & 0x80 ? bytes.subarray(head - 4, head) : Buffer.alloc(4);
  return Buffer.from(bytes.subarray(head).map((byte, n) => byte ^ (mask[n % 4] ?? 0))).toString();
}

/** The head of a request with the names of the server instead of the proxy's. */
const renamed = (head: string, proxy: string, server: string): string =>
  head.replaceAll(proxy, server);

const endOfHead = "\r\n\r\n";

/** Gathers heads until one of them says that it was the last; what follows is handed on as it comes. */
function untilHead(head: (text: string) => boolean, then: (data: Buffer) => void) {
  let [gathered, over] = ["", false];
  return (data: Buffer): void => {
    if (over) {
      then(data);
      return;
    }
    gathered += data.toString("latin1");
    const end = gathered.indexOf(endOfHead);
    if (end < 0) return;
    const rest = gathered.slice(end + endOfHead.length);
    over = head(gathered.slice(0, end + endOfHead.length));
    gathered = "";
    if (over) then(Buffer.from(rest, "latin1"));
  };
}

/** A proxy before a server. What is no WebSocket goes through as it is. */
export async function openProxy(server: string): Promise<RoughLink> {
  const { hostname, port, host } = new URL(server);
  const sockets = new Set<Socket>();
  let repeat: (text: string) => void = () => undefined;
  const listener = createServer((page) => {
    const beyond = dial(Number(port), hostname);
    for (const socket of [page, beyond]) {
      sockets.add(socket);
      socket.setNoDelay(true);
      socket.on("error", () => undefined);
      socket.on("close", () => {
        page.destroy();
        beyond.destroy();
      });
    }
    carry(page, beyond);
  });

  function carry(page: Socket, beyond: Socket): void {
    const [up, down] = [new Frames(), new Frames()];
    const kept = new Map<string, Buffer>();
    const upwards = (data: Buffer) => {
      for (const frame of up.take(data)) {
        kept.set(frame.text, frame.bytes);
        if (frame.text) proxy.heard.push({ text: frame.text, atMs: performance.now() });
        pass(frame, beyond, proxy.fromPage);
      }
    };
    const downwards = (data: Buffer) => {
      for (const frame of down.take(data)) pass(frame, page, proxy.fromServer);
    };
    let upgraded = false;
    const asks = untilHead((head) => {
      upgraded = /^upgrade:\s*websocket/im.test(head);
      if (upgraded) repeat = (text) => void beyond.write(kept.get(text) ?? Buffer.alloc(0));
      beyond.write(Buffer.from(renamed(head, own.host, host), "latin1"));
      return upgraded;
    }, upwards);
    const answers = untilHead((head) => {
      page.write(Buffer.from(head, "latin1"));
      return true;
    }, downwards);
    page.on("data", asks);
    beyond.on("data", (data) => (upgraded ? answers(data) : void page.write(data)));
  }

  /** Messages that wait keep their order. */
  function pass({ bytes, text }: Frame, to: Socket, decide: (text: string) => Fate): void {
    const { copies, afterMs } = text ? decide(text) : asUsual;
    const send = () => {
      for (let n = 0; n < copies; n += 1) to.write(bytes);
    };
    if (afterMs > 0) setTimeout(send, afterMs);
    else send();
  }

  const own = await new Promise<{ host: string }>((resolve) =>
    listener.listen(0, "127.0.0.1", () => {
      const bound = listener.address();
      resolve({ host: `127.0.0.1:${typeof bound === "object" ? bound?.port : ""}` });
    }),
  );
  const proxy: RoughLink = {
    address: `http://${own.host}`,
    fromPage: () => asUsual,
    fromServer: () => asUsual,
    heard: [],
    again: (text) => repeat(text),
    close() {
      listener.close();
      for (const socket of sockets) socket.destroy();
    },
  };
  return proxy;
}
