import { useState } from "react";
import { ask } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { Field } from "../ui/Field";
import { Panel } from "../ui/Panel";
import type { Act } from "../wire/messages";
import { t } from "../words/words";

/** Lets everybody change settings, or only who knows the password. */
export function Password() {
  const locked = useSnapshot("setup")?.protected ?? false;
  return (
    <Panel title="Password">
      <div className="password">{locked ? <Locked /> : <Free />}</div>
    </Panel>
  );
}

/** Asks; tells whether it was done. */
function useAsk() {
  const hands = useHands();
  return (act: Act) => ask(worldOf(hands), act);
}

function Free() {
  const send = useAsk();
  const [first, setFirst] = useState("");
  const [again, setAgain] = useState("");
  const differ = again !== "" && first !== again;
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        if (first !== again || first === "") return;
        void send({ do: "protect", password: null, new: [first, again] });
      }}
    >
      <p>{t("Without a password everybody who may change settings changes them at once.")}</p>
      <Field label="New password" type="password" value={first} onChange={setFirst} />
      <Field
        label="Once more"
        type="password"
        value={again}
        onChange={setAgain}
        error={differ ? t("The two are not the same.") : undefined}
      />
      <Button
        type="submit"
        refused={first === "" || first !== again ? t("Enter the same password twice.") : undefined}
      >
        Protect the settings
      </Button>
    </form>
  );
}

function Locked() {
  const send = useAsk();
  const { screen } = useHands();
  const [password, setPassword] = useState("");
  const unlock = async () => {
    if (await send({ do: "unlock", password }))
      screen.tell(t("This page may change settings now."));
    setPassword("");
  };
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void unlock();
      }}
    >
      <p>
        {t(
          "Settings are protected. The password opens them for this page, for a quarter of an hour.",
        )}
      </p>
      <Field label="Password" type="password" value={password} onChange={setPassword} />
      <div className="password-buttons">
        <Button
          type="submit"
          look="primary"
          refused={password === "" ? t("Enter the password first.") : undefined}
        >
          Open
        </Button>
        <Button
          refused={password === "" ? t("Enter the password first.") : undefined}
          onPress={() => void send({ do: "protect", password, new: null })}
        >
          Take the protection away
        </Button>
      </div>
    </form>
  );
}
