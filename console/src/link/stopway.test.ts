import { describe, expect, it, vi } from "vitest";
import type { Reply } from "../wire/messages";
import { onlyStops, StopWay, stopAddress } from "./stopway";

/** Sockets that were opened, newest last. */
class FakeSocket extends EventTarget {
  static readonly OPEN = 1;
  static opened: FakeSocket[] = [];
  readyState = 0;
  readonly sent: string[] = [];
  readonly address: string;
  constructor(address: string) {
    super();
    this.address = address;
    FakeSocket.opened.push(this);
  }
  send(text: string): void {
    this.sent.push(text);
  }
  close(): void {
    this.readyState = 3;
    this.dispatchEvent(new Event("close"));
  }
  answer(): void {
    this.readyState = FakeSocket.OPEN;
    this.dispatchEvent(new Event("open"));
  }
}

function way(): { way: StopWay; heard: Reply[]; newest: () => FakeSocket } {
  FakeSocket.opened = [];
  vi.stubGlobal("WebSocket", FakeSocket);
  const heard: Reply[] = [];
  const newest = () => FakeSocket.opened.at(-1) as FakeSocket;
  return { way: new StopWay((reply) => heard.push(reply)), heard, newest };
}

const stop = { id: 7, act: { do: "stop" } } as const;

describe("STOP's own way", () => {
  it("leads to the same machine by another port", () => {
    expect(stopAddress("ws://10.0.0.2:8710/ws", 8711, 3)).toBe("ws://10.0.0.2:8711/stop?client=3");
    expect(stopAddress("ws://[::1]:8710/ws", 8711, 3)).toBe("ws://[::1]:8711/stop?client=3");
  });

  it("is for what only stops", () => {
    expect(onlyStops({ do: "stop" })).toBe(true);
    expect(onlyStops({ do: "jogStop", seq: 1 })).toBe(true);
    expect(onlyStops({ do: "ping" })).toBe(false);
  });

  it("carries a press and its reply when it is open, and says when it is not", () => {
    const { way: own, heard, newest } = way();
    expect(own.press(stop)).toBe(false);
    own.lead("ws://here:1/stop?client=1");
    expect(own.press(stop)).toBe(false);
    newest().answer();
    expect(own.press(stop)).toBe(true);
    expect(newest().sent).toEqual([JSON.stringify(stop)]);
    const reply = { id: 7, problem: null, notes: [] };
    const data = JSON.stringify({ tell: "reply", ...reply });
    newest().dispatchEvent(new MessageEvent("message", { data }));
    expect(heard).toMatchObject([reply]);
  });

  it("is opened anew when it is lost, and not when the page has another number", () => {
    vi.useFakeTimers();
    const { way: own, newest } = way();
    own.lead("ws://here:1/stop?client=1");
    newest().close();
    vi.advanceTimersByTime(500);
    expect(FakeSocket.opened.length).toBe(2);
    own.lead("ws://here:1/stop?client=2");
    expect(FakeSocket.opened.length).toBe(3);
    vi.advanceTimersByTime(60_000);
    expect(FakeSocket.opened.length).toBe(3);
    own.lead(undefined);
    vi.useRealTimers();
  });
});
