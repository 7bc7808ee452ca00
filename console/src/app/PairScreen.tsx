import { useEffect, useState } from "react";
import { postJson } from "../link/http";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Sheet } from "../ui/Sheet";
import { phrase, t } from "../words/words";
import { useShown } from "./context";
import { useWords } from "./useWords";
import "./pair-screen.css";

/** Asks for the code that the machine shows, on a device that is not paired. */
export function PairScreen() {
  const unpaired = useUnpaired();
  const [code, setCode] = useState("");
  const [name, setName] = useState("");
  const words = useWords();
  const [why, setWhy] = useState<string>();
  if (!unpaired) return null;
  // What was wrong with the code before says nothing of this one.
  const enter = (text: string) => {
    setCode(text);
    setWhy(undefined);
  };
  const ready = code.trim() !== "" && name.trim() !== "";
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
        <Button
          look="primary"
          size="large"
          refused={ready ? undefined : t("Enter the code and a name first.")}
          onPress={() => void pair()}
        >
          Pair
        </Button>
      }
    >
      <p className="tool-words">
        {phrase(
          "At the machine, open Settings and let a device in: it shows a code. Enter it here. On the computer of the machine itself, open the address that {0} printed.",
          <code>kerf serve</code>,
        )}
      </p>
      <form
        className="pair-fields"
        // The same code may be right in a moment.
        noValidate
        onSubmit={(event) => {
          event.preventDefault();
          if (ready) void pair();
        }}
      >
        <Field label="Code" value={code} onChange={enter} error={why && words(why)} first />
        <Field label="Name of this device" value={name} onChange={setName} placeholder="Tablet" />
        <button type="submit" hidden />
      </form>
    </Sheet>
  );
}

/** Tells whether this device is unknown to the server. */
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
