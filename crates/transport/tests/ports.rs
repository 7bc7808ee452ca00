//! Ports on pseudo terminals, as a controller or a cable would be behind them.
#![cfg(unix)]
#![allow(clippy::unwrap_used, non_snake_case)]

use kerf_transport::pretend::{Cable, Plug};
use kerf_transport::{LineError, Port};
use std::time::{Duration, Instant};

const SOON: Duration = Duration::from_secs(5);

fn read(port: &mut Port, count: usize) -> Vec<u8> {
    let (mut got, begin) = (Vec::new(), Instant::now());
    let mut bytes = [0; 4096];
    while got.len() < count && begin.elapsed() < SOON {
        let more = port.read(&mut bytes, Duration::from_millis(50)).unwrap();
        got.extend_from_slice(&bytes[..more]);
    }
    got
}

#[test]
fn every_byte_passes_as_it_is() {
    let mut plug = Plug::new().unwrap();
    let mut port = Port::open(plug.path(), 115_200).unwrap();
    let all: Vec<u8> = (0..=255).collect();
    plug.write(&all).unwrap();
    assert_eq!(read(&mut port, 256), all);
    port.write(&all).unwrap();
    let mut back = Vec::new();
    let mut bytes = [0; 300];
    while back.len() < 256 {
        let count = plug.read(&mut bytes, SOON).unwrap();
        assert!(count > 0, "{} bytes came", back.len());
        back.extend_from_slice(&bytes[..count]);
    }
    assert_eq!(back, all);
    assert_eq!(plug.baud(), Ok(115_200));
}

#[test]
fn silence_is_no_error_and_a_pulled_plug_is_one() {
    let plug = Plug::new().unwrap();
    let mut port = Port::open(plug.path(), 9600).unwrap();
    let mut bytes = [0; 10];
    assert_eq!(port.read(&mut bytes, Duration::from_millis(20)), Ok(0));
    drop(plug);
    let read = port.read(&mut bytes, Duration::from_millis(20));
    assert!(matches!(read, Err(LineError::Gone { .. })), "{read:?}");
    let written = port.write(b"?");
    assert!(matches!(written, Err(LineError::Gone { .. })), "{written:?}");
}

#[test]
fn what_came_before_the_port_was_opened_is_dropped() {
    let mut plug = Plug::new().unwrap();
    plug.write(b"old").unwrap();
    let mut port = Port::open(plug.path(), 9600).unwrap();
    plug.write(b"new").unwrap();
    assert_eq!(read(&mut port, 3), b"new");
}

#[test]
fn what_is_no_port_is_told_by_its_name() {
    let missing = Port::open("/dev/no-such-port", 9600).unwrap_err();
    assert!(missing.to_string().contains("no serial port /dev/no-such-port"), "{missing}");
    let file = tempfile::NamedTempFile::new().unwrap();
    let unfit = Port::open(file.path().to_str().unwrap(), 9600).unwrap_err();
    assert!(matches!(unfit, LineError::Unfit { .. }), "{unfit:?}");
}

#[test]
fn a_cable_is_as_slow_as_its_ports() {
    for baud in [9600, 38_400] {
        let cable = Cable::new().unwrap();
        let [mut near, mut far] = cable.ends().map(|end| Port::open(end, baud).unwrap());
        let sent: Vec<u8> = (0..2000_u32).map(|i| (i * 7) as u8).collect();
        let begin = Instant::now();
        near.write(&sent).unwrap();
        assert_eq!(read(&mut far, sent.len()), sent);
        let least_s = 2000.0 * 10.0 / f64::from(baud);
        assert!(begin.elapsed().as_secs_f64() >= 0.98 * least_s, "{baud}: {:?}", begin.elapsed());
    }
}

#[test]
fn a_cable_spoils_what_it_is_told_to_and_everything_between_unequal_rates() {
    let cable = Cable::new().unwrap();
    let [mut near, mut far] = cable.ends().map(|end| Port::open(end, 38_400).unwrap());
    cable.spoil_after(2);
    near.write(b"abcdef").unwrap();
    assert_eq!(read(&mut far, 6), b"abGdef");
    let end = cable.ends()[1].to_owned();
    drop(far);
    let mut far = Port::open(&end, 9600).unwrap();
    near.write(b"abc").unwrap();
    let spoiled = read(&mut far, 3);
    assert!(spoiled.len() == 3 && spoiled != b"abc", "{spoiled:?}");
    cable.cut();
    near.write(b"abc").unwrap();
    assert_eq!(far.read(&mut [0; 3], Duration::from_millis(50)), Ok(0));
}

/// Seconds that so many bytes take over a cable.
fn takes_s(baud: u32, count: usize) -> f64 {
    let cable = Cable::new().unwrap();
    let [mut near, mut far] = cable.ends().map(|end| Port::open(end, baud).unwrap());
    let begin = Instant::now();
    near.write(&vec![0x55; count]).unwrap();
    assert_eq!(read(&mut far, count).len(), count);
    begin.elapsed().as_secs_f64()
}

#[test]
fn pro_send_speed__the_line_is_as_fast_as_its_rate() {
    // A second each, side by side; a busy computer may be late once, and again.
    let second = |baud: u32| {
        let count = baud as usize / 10;
        let off = (0..10).map(|_| takes_s(baud, count) - 1.0).find(|off| off.abs() <= 0.02);
        assert!(off.is_some(), "{baud} baud: not a second for {count} bytes");
    };
    std::thread::scope(|scope| {
        for baud in [2400, 4800, 9600, 19_200, 38_400] {
            scope.spawn(move || second(baud));
        }
    });
}

/// A second's worth of bytes, in an eighth of it.
#[test]
fn a_hurried_cable_carries_more() {
    let cable = Cable::hurried(8.0).unwrap();
    let [mut near, mut far] = cable.ends().map(|end| Port::open(end, 9600).unwrap());
    let begin = Instant::now();
    near.write(&[0x55; 960]).unwrap();
    assert_eq!(read(&mut far, 960).len(), 960);
    assert!(begin.elapsed() > Duration::from_millis(120), "{:?}", begin.elapsed());
    assert!(begin.elapsed() < Duration::from_millis(900), "{:?}", begin.elapsed());
    assert_eq!(cable.carried(), 960);
}
