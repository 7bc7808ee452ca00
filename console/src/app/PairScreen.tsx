import { useEffect, useState } from "react";
import { postJson } from "../link/http";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { useShown } from "./context";

/** Asks for the code that the machine shows, on a device that is not paired. */
export function PairScreen() {
  const unpaired = useUnpaired();
  const [code, setCode] = useState("");
  const [name, setName] = useState("");
  const [why, setWhy] = useState<string>();
  if (!unpaired) return null;
  const pair = () =>
    postJson("/api/pair", { code, name }).then(
      () => location.reload(),
      (error: Error) => setWhy(error.message),
    );
  return (
    <Sheet
      title="Pair this device"
      shape="question"
      foot={
        <Button look="primary" size="large" isDisabled={!code || !name} onPress={() => void pair()}>
          Pair
        </Button>
      }
    >
      <p className="tool-words">
        At the machine, open Settings and let a device in: it shows a code. Enter it here.
      </p>
      <Field label="Code" value={code} onChange={setCode} error={why} first />
      <Field label="Name of this device" value={name} onChange={setName} placeholder="Tablet" />
    </Sheet>
  );
}

/** Whether the server does not know this device. */
function useUnpaired(): boolean {
  const status = useShown((shown) => shown.status);
  const [unpaired, setUnpaired] = useState(false);
  useEffect(() => {
    if (status !== "opening") return setUnpaired(false);
    let wanted = true;
    const asked = setTimeout(async () => {
      const response = await fetch("/api/state").catch(() => null);
      if (wanted) setUnpaired(response?.status === 401);
    }, 400);
    return () => {
      wanted = false;
      clearTimeout(asked);
    };
  }, [status]);
  return unpaired;
}
