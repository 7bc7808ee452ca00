import { useSnapshot } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { Button } from "../ui/Button";
import type { SettingEntry } from "../wire/messages";
import { t } from "../words/words";
import { boundText, docOf, fullName, shortName, topicName } from "./names";
import { cellValue, SettingValue, useSet, usualText } from "./SettingValue";
import { partsOf, type Row, type Table, type Topic } from "./tables";
import { shownUnit } from "./value";

const isChanged = ({ value, default: usual }: SettingEntry) =>
  partsOf(value).join() !== partsOf(usual).join();

/** The settings of a topic: axes side by side, then what has one value. */
export function TopicTables({ topic }: { topic: Topic }) {
  return (
    <section className="topic" aria-label={topicName(topic.title)}>
      <h3>{topicName(topic.title)}</h3>
      {topic.tables.map((table) => (
        <SettingTable key={table.columns.join()} table={table} />
      ))}
      {topic.single.length > 0 && (
        <ul className="topic-single">
          {topic.single.map((entry) => (
            <SingleSetting key={`${entry.key} ${entry.value}`} entry={entry} />
          ))}
        </ul>
      )}
    </section>
  );
}

function SettingTable({ table: { columns, rows } }: { table: Table }) {
  return (
    <div className="topic-table">
      <table>
        <thead>
          <tr>
            <td />
            {columns.map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
            <td />
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <SettingRow
              key={[...row.cells.values()][0]?.entry.key ?? row.name}
              row={row}
              columns={columns}
            />
          ))}
        </tbody>
      </table>
    </div>
  );
}

function SettingRow({ row, columns }: { row: Row; columns: readonly string[] }) {
  const units = useSnapshot("units");
  const page = useLengthUnit();
  const values = columns.flatMap((column) => {
    const cell = row.cells.get(column);
    return cell ? [{ column, value: cellValue(cell, column, units) }] : [];
  });
  const shown = new Set(values.map(({ value }) => shownUnit(value, page).unit));
  return (
    <tr title={row.doc}>
      <th scope="row">
        {row.name} <span className="setting-unit">{[...shown].filter(Boolean).join(", ")}</span>
      </th>
      {columns.map((column) => {
        const cell = row.cells.get(column);
        const value = values.find((one) => one.column === column)?.value;
        if (!cell || !value) return <td key={column} />;
        return (
          <td key={column} className={value.value === value.default ? "" : "setting-changed"}>
            <SettingValue
              key={cell.entry.value}
              cell={cell}
              column={column}
              label={`${row.name}, ${column}`}
            />
          </td>
        );
      })}
      <td>
        <Usual
          entries={[...new Set([...row.cells.values()].map(({ entry }) => entry))]}
          name={row.name}
        />
      </td>
    </tr>
  );
}

function SingleSetting({ entry }: { entry: SettingEntry }) {
  const { unit } = shownUnit(entry, useLengthUnit());
  return (
    <li className={isChanged(entry) ? "setting setting-changed" : "setting"} data-key={entry.key}>
      <div>
        <b>{shortName(entry.key)}</b> <span className="setting-unit">{unit}</span>
        <p className="setting-doc">
          {docOf(entry)} {entry.bound && t("Allowed: {0}.", boundText(entry.bound))}
        </p>
      </div>
      <SettingValue cell={{ entry }} label={fullName(entry.key)} />
      <Usual entries={[entry]} name={shortName(entry.key)} />
    </li>
  );
}

/** Takes the usual values again; not there where they are. */
function Usual({ entries, name }: { entries: readonly SettingEntry[]; name: string }) {
  const set = useSet();
  const page = useLengthUnit();
  const changed = entries.filter(isChanged);
  const [first] = changed;
  if (!first) return null;
  const words = changed.length === 1 ? usualText(first, page) : t("the usual values");
  const reset = async () => {
    for (const { key, default: usual } of changed) if (!(await set(key, usual))) return;
  };
  return (
    <Button
      size="small"
      look="quiet"
      className="setting-usual"
      aria-label={t("Usual: {0}", name)}
      onPress={() => void reset()}
    >
      ↺ {words}
    </Button>
  );
}
