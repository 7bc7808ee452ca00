import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { useBusy } from "../app/useBusy";
import { useFetched } from "../app/useFetched";
import { Button } from "../ui/Button";
import { Sheet } from "../ui/Sheet";
import type { PortBit, Ports } from "../wire/messages";
import { t } from "../words/words";
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
  const hands = useHands();
  const busy = useBusy();
  const card = useSnapshot("machine")?.offers.card ?? false;
  const switchBit = ({ port, place }: PortBit, on: boolean) =>
    void drive(worldOf(hands), { do: "bit", name: `${port}${place}`, on });
  const step = (motor: string, forward: boolean) =>
    void drive(worldOf(hands), { do: "step", motor, forward });
  return (
    <Sheet title="Ports of the card" shape="wide" onClose={onClose}>
      {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls must be reached by key */}
      <section className="ports" aria-label={t("Lamps")} tabIndex={0} data-first>
        {ports &&
          portsOf(bits, ports).map(({ title, byte, bits }) => (
            <section key={title} aria-label={title}>
              <h3>
                {title} <output>0x{byte.toString(16).toUpperCase().padStart(2, "0")}</output>
              </h3>
              <ul>
                {bits.map((bit) => (
                  <Light
                    key={bit.place}
                    bit={bit}
                    on={((byte >> bit.place) & 1) === 1}
                    busy={busy}
                    onSwitch={card && isSwitched(bit) ? switchBit : undefined}
                  />
                ))}
              </ul>
            </section>
          ))}
        {card && (
          <section aria-label={t("Motors")}>
            <h3>{t("Motors")}</h3>
            <p className="ports-words">
              {t(
                "One step at a time. An output that is switched on starts what hangs on it: is everybody clear of it?",
              )}
            </p>
            <ul className="port-motors">
              {motorsOf(bits).map((motor) => (
                <li key={motor}>
                  <b>{motor}</b>
                  {[false, true].map((forward) => (
                    <Button
                      key={String(forward)}
                      size="small"
                      refused={busy}
                      aria-label={t("Step {0} {1}", motor, forward ? t("forward") : t("back"))}
                      onPress={() => step(motor, forward)}
                    >
                      {forward ? "+" : "−"}
                    </Button>
                  ))}
                </li>
              ))}
            </ul>
          </section>
        )}
      </section>
    </Sheet>
  );
}

/** The ends of the names of a motor's bits. */
const motorBit = /(step|dir)$/;

const isSwitched = ({ output, name }: PortBit): boolean => output && !motorBit.test(name);

/** The motors that have a bit for their steps. */
const motorsOf = (bits: readonly PortBit[]): string[] =>
  bits
    .filter(({ output, name }) => output && name.endsWith("step"))
    .map(({ name }) => name.replace(motorBit, ""));

interface LightProps {
  bit: PortBit;
  on: boolean;
  busy: string | undefined;
  /** Nothing for what cannot be switched by hand. */
  onSwitch: ((bit: PortBit, on: boolean) => void) | undefined;
}

function Light({ bit, on, busy, onSwitch }: LightProps) {
  const { port, place, name, about, output } = bit;
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
      <em>{on ? t("on") : t("off")}</em>
      {onSwitch && (
        <Button
          size="small"
          refused={busy}
          aria-label={t("Switch {0} {1}", name, on ? t("off") : t("on"))}
          onPress={() => onSwitch(bit, !on)}
        >
          Switch
        </Button>
      )}
    </li>
  );
}

/** Inputs first: they are what is looked for when something does not work. */
export function portsOf(bits: readonly PortBit[], ports: Ports): PortLamps[] {
  const one = (output: boolean, letter: string, byte: number): PortLamps => ({
    title: t("{0} port {1}", output ? t("Output") : t("Input"), letter),
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

const none: readonly PortBit[] = [];

/** The names of the bits, read anew when the machine changed. */
const useBits = (): readonly PortBit[] => useFetched("/api/ports", none, useSnapshot("settings"));
