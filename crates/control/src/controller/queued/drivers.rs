//! Motor drivers of a machine's file as those of a setup.

use super::pins::Pins;
use kerf_driver_klipper::setup::{Driver, DriverSelect, DriverWire, Pin, RegisterLink, Setup};
use kerf_driver_klipper::tmc::{Chip, Tuning};
use kerf_machine::Configuration;
use kerf_machine::settings::motors::Motor;

/// Puts the driver of a motor into a setup, where the machine's file names one.
///
/// # Errors
/// It is no driver with its pins, or cannot be set so; in words.
pub fn add(
    setup: &mut Setup,
    pins: &Pins,
    machine: &Configuration,
    name: Motor,
) -> Result<(), String> {
    let text = machine.drivers.kinds[name.index()].trim();
    let key = format!("drivers.{}", name.word());
    let mut words = text.split_whitespace();
    let Some(kind) = words.next() else { return Ok(()) };
    let chip = Chip::named(kind).ok_or_else(|| {
        let kinds: Vec<_> = Chip::NAMES.iter().map(|(name, _)| *name).collect();
        format!("{key}: \"{kind}\" is no driver that is known: {}", kinds.join(", "))
    })?;
    let words: Vec<&str> = words.collect();
    let way = match words[..] {
        [cs] if chip.has_select() => select(setup, pins, machine, (&key, cs))?,
        [rx] if !chip.has_select() => wire(setup, pins, &key, [rx, rx], 0)?,
        [rx, tx] if !chip.has_select() => match tx.parse() {
            Ok(address) => wire(setup, pins, &key, [rx, rx], address)?,
            Err(_) => wire(setup, pins, &key, [rx, tx], 0)?,
        },
        [rx, tx, address] if !chip.has_select() => {
            let address = address.parse().map_err(|_| format!("{key}: {address} is no address"))?;
            wire(setup, pins, &key, [rx, tx], address)?
        }
        _ => {
            return Err(format!(
                "{key} = \"{text}\": name its pins: {}",
                if chip.has_select() { "\"tmc5160 PC4\"" } else { "\"tmc2209 gpio9 gpio8 2\"" }
            ));
        }
    };
    let tuning = tuning(machine, chip, name);
    tuning
        .writes()
        .map_err(|why| format!("{key}: {why} (drivers.current_a, ohms, microsteps, stall)"))?;
    setup.tuned.push(Driver { name: name.word().to_uppercase(), way, tuning });
    Ok(())
}

fn tuning(machine: &Configuration, chip: Chip, name: Motor) -> Tuning {
    let (drivers, n) = (&machine.drivers, name.index());
    let ohms = Some(drivers.ohms[n]).filter(|ohms| *ohms > 0.0);
    Tuning {
        chip,
        current_a: drivers.current_a[n],
        hold: drivers.hold,
        ohms: ohms.unwrap_or(chip.usual_ohms()),
        microsteps: drivers.microsteps[n],
        interpolates: drivers.interpolates,
        quiet: drivers.quiet,
        stall: drivers.stall[n],
        both_edges: machine.board.both_edges,
    }
}

/// The wire of these pins, and an address on it.
fn wire(
    setup: &mut Setup,
    pins: &Pins,
    key: &str,
    [rx, tx]: [&str; 2],
    address: u8,
) -> Result<RegisterLink, String> {
    if address > 3 {
        return Err(format!("{key}: a driver has an address from 0 to 3, not {address}"));
    }
    let wire = DriverWire { rx: pins.pin(key, rx)?, tx: pins.pin(key, tx)? };
    let is_it =
        |other: &DriverWire| (other.rx.board, &other.rx.name) == (wire.rx.board, &wire.rx.name);
    let wire = setup.drivers.iter().position(is_it).unwrap_or_else(|| {
        setup.drivers.push(wire.clone());
        setup.drivers.len() - 1
    });
    let is_taken = setup.tuned.iter().find(|it| it.way == RegisterLink::Wire { wire, address });
    match is_taken {
        Some(other) => {
            Err(format!("{key}: motor {} has address {address} on that wire already", other.name))
        }
        None => Ok(RegisterLink::Wire { wire, address }),
    }
}

/// A chip select on the bus of the board.
fn select(
    setup: &mut Setup,
    pins: &Pins,
    machine: &Configuration,
    (key, cs): (&str, &str),
) -> Result<RegisterLink, String> {
    let words: Vec<&str> = machine.drivers.spi.split_whitespace().collect();
    let Ok([miso, mosi, sck]) = <[&str; 3]>::try_from(words) else {
        return Err("drivers.spi: name MISO, MOSI and SCK: \"PA6 PA7 PA5\"".into());
    };
    let pin = |name: &str| pins.pin("drivers.spi", name);
    let bus: [Pin; 3] = [pin(miso)?, pin(mosi)?, pin(sck)?];
    setup.selects.push(DriverSelect { cs: pins.pin(key, cs)?, bus });
    Ok(RegisterLink::Select(setup.selects.len() - 1))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::wiring::Wiring;

    fn check(drivers: &str, expected: Result<[usize; 3], &str>) {
        let text = format!("[board]\nx = \"a b\"\ny = \"c d\"\n[drivers]\n{drivers}\n");
        let machine = kerf_machine::file::read(&"m.toml".into(), &text).unwrap();
        match (Wiring::of(&machine), expected) {
            (Ok(Wiring { setup, .. }), Ok(counts)) => {
                assert_eq!([setup.drivers.len(), setup.selects.len(), setup.tuned.len()], counts);
            }
            (Err(why), Err(part)) => assert!(why.contains(part), "{why}"),
            (found, _) => panic!("{drivers}: {found:?}"),
        }
    }

    #[test]
    fn drivers_are_on_wires_and_behind_selects() {
        let current = "current_a = [0.8, 0.8, 0, 0, 0, 0]\n";
        let check = |lines: &str, expected| check(&format!("{current}{lines}"), expected);
        check("", Ok([0, 0, 0]));
        check("x = \"tmc2209 e f 0\"\ny = \"tmc2209 e f 2\"", Ok([1, 0, 2]));
        check("x = \"tmc2208 e\"\ny = \"TMC2209 f 3\"", Ok([2, 0, 2]));
        check("x = \"tmc5160 e\"\ny = \"tmc2130 f\"\nspi = \"g h i\"", Ok([0, 2, 2]));
        check(
            "x = \"tmc2209 e f 0\"\ny = \"tmc2209 e f 0\"",
            Err("address 0 on that wire already"),
        );
        check("x = \"tmc2209 e f 4\"", Err("from 0 to 3"));
        check("x = \"tmc5160 e\"", Err("drivers.spi: name MISO"));
        check("x = \"tmc5160 e f\"", Err("name its pins"));
        check("x = \"tmc2209\"", Err("name its pins"));
        check("x = \"a4988 e\"", Err("no driver that is known"));
    }

    #[test]
    fn a_driver_without_a_current_is_refused() {
        check("x = \"tmc2209 e\"", Err("drivers.x: no current is set"));
    }
}
