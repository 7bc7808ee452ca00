//! The password of the settings: kept as a salted hash, never as it was typed.
//!
//! `pbkdf2-sha256$ROUNDS$SALT$HASH` with salt and hash in hexadecimal digits, so that more rounds can be
//! asked for later and old ones still open.

use pbkdf2::pbkdf2_hmac_array;
use sha2::Sha256;
use subtle::ConstantTimeEq;

/// Number of times that the hash is made of itself: the cost of a guess.
const ROUNDS: u32 = 100_000;
/// Rounds that a hash in a file may ask for: a slip there must not stand still for minutes.
const MOST_ROUNDS: u32 = 10_000_000;
const NAME: &str = "pbkdf2-sha256";
/// Characters of the shortest password.
pub const SHORTEST: usize = 4;

/// Returns what is kept of a password. The salt comes from outside: chance is not ours.
pub fn hashed(password: &str, salt: [u8; 16]) -> String {
    let hash = pbkdf2_hmac_array::<Sha256, 32>(password.as_bytes(), &salt, ROUNDS);
    format!("{NAME}${ROUNDS}${}${}", digits(&salt), digits(&hash))
}

/// Tells whether a password is the one of which this was kept. What is no hash at all fits nothing.
pub fn fits(kept: &str, password: &str) -> bool {
    let Some((rounds, salt, hash)) = parts(kept) else { return false };
    let tried = pbkdf2_hmac_array::<Sha256, 32>(password.as_bytes(), &salt, rounds);
    bool::from(tried.ct_eq(hash.as_slice()))
}

fn parts(kept: &str) -> Option<(u32, Vec<u8>, Vec<u8>)> {
    let mut parts = kept.split('$');
    let (name, rounds) = (parts.next()?, parts.next()?.parse().ok()?);
    let (salt, hash) = (bytes(parts.next()?)?, bytes(parts.next()?)?);
    let known = name == NAME && parts.next().is_none() && (1..=MOST_ROUNDS).contains(&rounds);
    known.then_some((rounds, salt, hash))
}

fn digits(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

fn bytes(digits: &str) -> Option<Vec<u8>> {
    let pairs = digits.as_bytes().chunks(2);
    pairs.map(|pair| u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_password_fits_and_it_is_not_kept() {
        let one = hashed("birch plywood", [7; 16]);
        assert!(fits(&one, "birch plywood"));
        assert!(!fits(&one, "birch plywooD") && !fits(&one, ""));
        assert!(!one.contains("birch"));
        assert_ne!(one, hashed("birch plywood", [8; 16]), "the salt makes them differ");
    }

    #[test]
    fn what_is_no_hash_fits_nothing() {
        for text in ["", "birch", "$$$", "pbkdf2-sha256$0$00$00", "pbkdf2-sha256$99999999999$00$00"]
        {
            assert!(!fits(text, text), "{text}");
        }
    }
}
