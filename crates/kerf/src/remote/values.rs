//! The values of the external control, as a server keeps them.

use super::Remote;
use anyhow::Result;

impl Remote {
    /// Every value with its key.
    pub fn values(&self) -> Result<Vec<(String, String)>> {
        let all = self.ask("GET", "/api/registry", "")?;
        let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
        let pair = |entry: &serde_json::Value| (text(&entry["name"]), text(&entry["value"]));
        Ok(all.as_array().into_iter().flatten().map(pair).collect())
    }

    /// Sets a value; without one the key is removed.
    pub fn set_value(&self, key: &str, value: Option<&str>) -> Result<()> {
        let path = format!("/api/registry/{}", encoded(key));
        self.request("PUT", &path, value.unwrap_or_default()).map(drop)
    }
}

/// A name as an address takes it (RFC 3986, 2.3).
fn encoded(name: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~/".contains(&byte);
    let sign = |byte: u8| match plain(byte) {
        true => char::from(byte).to_string(),
        false => format!("%{byte:02X}"),
    };
    name.bytes().map(sign).collect()
}
