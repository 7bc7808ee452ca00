//! Motor drivers with registers behind a pin: what they hear, what they answer.

use std::collections::BTreeMap;

/// A motor driver on a wire or behind a chip select.
#[derive(Clone, Debug, Default)]
pub struct Chip {
    /// Its pin: of the wire on which it hears, or its select.
    pub pin: u32,
    pub address: u8,
    pub registers: BTreeMap<u8, u32>,
    /// It has no supply: nothing is heard or said.
    pub dead: bool,
    /// Datagrams that it misses before it hears one, at each write.
    pub deaf: u32,
    missed: u32,
    /// Data of the datagram before, behind a select.
    before: u32,
}

const COUNT: u8 = 0x02;

impl Chip {
    /// One that tells this version at this register.
    pub fn new(pin: u32, address: u8, (register, version): (u8, u8)) -> Self {
        let registers = [(register, u32::from(version) << 24), (0x01, 1)].into_iter().collect();
        Self { pin, address, registers, ..Self::default() }
    }

    pub fn tmc2209(pin: u32, address: u8) -> Self {
        Self::new(pin, address, (0x06, 0x21))
    }

    pub fn tmc2130(pin: u32) -> Self {
        Self::new(pin, 0, (0x04, 0x11))
    }

    pub fn get(&self, register: u8) -> u32 {
        self.registers.get(&register).copied().unwrap_or(0)
    }

    fn put(&mut self, register: u8, value: u32) {
        // Bits of the state of the chip are cleared by ones.
        let kept = if register == 0x01 { self.get(1) & !value } else { value };
        self.registers.insert(register, kept);
    }

    /// A datagram on the wire; the answer to it.
    pub fn hear(&mut self, bytes: &[u8]) -> Option<Vec<u8>> {
        let (sum, rest) = bytes.split_last()?;
        if self.dead || rest.first() != Some(&0x05) || crc(rest) != *sum || rest[1] != self.address
        {
            return None;
        }
        match rest {
            [_, _, register] => {
                let value = self.get(*register).to_be_bytes();
                let answer = [&[0x05, 0xff, *register][..], &value].concat();
                Some([&answer[..], &[crc(&answer)]].concat())
            }
            [_, _, register, a, b, c, d] if self.missed >= self.deaf => {
                self.missed = 0;
                self.put(register & 0x7f, u32::from_be_bytes([*a, *b, *c, *d]));
                let count = (self.get(COUNT) + 1) % 256;
                self.registers.insert(COUNT, count);
                None
            }
            _ => {
                self.missed += 1;
                None
            }
        }
    }

    /// A datagram behind the select; the bytes that come at the same time.
    pub fn swap(&mut self, bytes: &[u8]) -> Vec<u8> {
        let [of, a, b, c, d] = *bytes else { return vec![0xff; bytes.len()] };
        if self.dead {
            return vec![0xff; 5];
        }
        let answer = [&[0x08][..], &self.before.to_be_bytes()].concat();
        let value = u32::from_be_bytes([a, b, c, d]);
        if of & 0x80 != 0 && self.missed >= self.deaf {
            self.missed = 0;
            self.put(of & 0x7f, value);
            self.before = value;
        } else if of & 0x80 != 0 {
            (self.missed, self.before) = (self.missed + 1, 0);
        } else {
            self.before = self.get(of);
        }
        answer
    }
}

/// Check number of a datagram, bit by bit.
fn crc(bytes: &[u8]) -> u8 {
    let mut crc = 0_u8;
    for byte in bytes {
        let mut byte = *byte;
        for _ in 0..8 {
            let turns = (crc >> 7) ^ (byte & 1) == 1;
            crc = if turns { (crc << 1) ^ 0x07 } else { crc << 1 };
            byte >>= 1;
        }
    }
    crc
}

/// Bytes between start and stop bits.
pub fn bytes_of(bits: &[u8]) -> Vec<u8> {
    let whole = bits.iter().rev().fold(0_u128, |whole, byte| whole << 8 | u128::from(*byte));
    (0..bits.len() * 8 / 10).map(|n| (whole >> (10 * n + 1)) as u8).collect()
}

/// Bits of bytes with start and stop bits.
pub fn bits_of(bytes: &[u8]) -> Vec<u8> {
    let word = |byte: u8| u128::from(byte) << 1 | 1 << 9;
    let whole = bytes.iter().rev().fold(0_u128, |whole, byte| whole << 10 | word(*byte));
    whole.to_le_bytes()[..(bytes.len() * 10).div_ceil(8)].to_vec()
}
