import { useEffect, useState } from "react";
import { useSnapshot } from "../app/context";
import { getJson } from "../link/http";
import { Sheet } from "../ui/Sheet";
import type { PortBit, Ports } from "../wire/messages";
import "./ports.css";

/** The bits of one port, and its byte. */
interface PortLamps {
  readonly title: string;
  readonly byte: number;
  readonly bits: readonly PortBit[];
}

/** The ports of the card with a lamp for each bit, as they are now. */
export function PortsSheet({ onClose }: { onClose: () => void }) {
  const ports = useSnapshot("io")?.ports;
  const bits = useBits();
  return (
    <Sheet title="Ports of the card" shape="wide" onClose={onClose}>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by key */}
      <section className="ports" aria-label="Lamps" tabIndex={0} data-first>
        {ports &&
          portsOf(bits, ports).map(({ title, byte, bits }) => (
            <section key={title} aria-label={title}>
              <h3>
                {title} <output>0x{byte.toString(16).toUpperCase().padStart(2, "0")}</output>
              </h3>
              <ul>
                {bits.map((bit) => (
                  <Light key={bit.place} bit={bit} on={((byte >> bit.place) & 1) === 1} />
                ))}
              </ul>
            </section>
          ))}
      </section>
    </Sheet>
  );
}

function Light({ bit: { port, place, name, about, output }, on }: { bit: PortBit; on: boolean }) {
  const side = output ? "out" : "in";
  return (
    <li className={on ? "port-bit port-on" : "port-bit"} data-bit={`${side}.${name}`}>
      <i aria-hidden="true" />
      <b>
        {port}
        {place}
      </b>
      <span>
        {name}
        <small>{about}</small>
      </span>
      <em>{on ? "on" : "off"}</em>
    </li>
  );
}

/** Inputs first: they are what is looked for when something does not work. */
export function portsOf(bits: readonly PortBit[], ports: Ports): PortLamps[] {
  const one = (output: boolean, letter: string, byte: number): PortLamps => ({
    title: `${output ? "Output" : "Input"} port ${letter}`,
    byte,
    bits: bits.filter((bit) => bit.output === output && bit.port === letter),
  });
  const [inA, inB] = ports.inputs;
  const [a, b, c] = ports.outputs;
  return [
    one(false, "A", inA),
    one(false, "B", inB),
    one(true, "A", a),
    one(true, "B", b),
    one(true, "C", c),
  ];
}

/** The names of the bits, read anew when the machine changed. */
function useBits(): readonly PortBit[] {
  const changes = useSnapshot("settings");
  const [bits, setBits] = useState<readonly PortBit[]>([]);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what a bit is called is a setting
  useEffect(() => {
    getJson<PortBit[]>("/api/ports").then(setBits, () => undefined);
  }, [changes]);
  return bits;
}
