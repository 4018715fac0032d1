"""Material tools: replacement materials, tint and scales over an asset's own maps."""
