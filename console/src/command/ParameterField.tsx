import { Choice } from "../ui/Choice";
import { Field, Required } from "../ui/Field";
import { Pick } from "../ui/Pick";
import type { Parameter } from "../wire/messages";
import { choiceWords, parameterWords } from "../words/commands";
import { t } from "../words/words";
import { rangeText } from "./sheet";

interface ParameterFieldProps {
  parameter: Parameter;
  value: string;
  mistake: string | undefined;
  first: boolean;
  onChange: (text: string) => void;
}

/** Most words that are all in sight at once. */
const fewWords = 4;

/** The field of one parameter, with what it means and what it may be. */
export function ParameterField({
  parameter,
  value,
  mistake,
  first,
  onChange,
}: ParameterFieldProps) {
  const { kind, doc } = parameter;
  const name = parameterWords(parameter.name);
  if (kind.is === "choice") {
    const options = kind.words.map((word) => ({ value: word, words: choiceWords(word) }));
    const few = options.length <= fewWords && kind.words.join("").length < 20;
    return (
      <div className="parameter" title={doc}>
        <span className="field-label">
          {name}
          {parameter.required && <Required />}
        </span>
        {few ? (
          <Choice label={name} options={options} value={value} onChange={onChange} first={first} />
        ) : (
          <Pick label={name} options={options} value={value} onChange={onChange} />
        )}
        <span className="field-hint">{facts(parameter)}</span>
        {mistake && <span className="field-error">{mistake}</span>}
      </div>
    );
  }
  return (
    <div title={doc}>
      <Field
        label={name}
        value={value}
        onChange={onChange}
        isRequired={parameter.required}
        isDisabled={kind.is === "obsolete"}
        unit={parameter.unit}
        hint={facts(parameter)}
        error={mistake}
        first={first}
      />
    </div>
  );
}

/** Default and range in few words. */
function facts({ default: usual, bound, least, most }: Parameter): string {
  const range = bound || rangeText(least, most);
  return [usual !== null ? t("default {0}", choiceWords(usual)) : "", range]
    .filter((text) => text !== "")
    .join(", ");
}
