//! Entities of DXF that are no shapes to cut: they are counted, where a name that nobody knows is told with
//! its line.

/// Names of the DXF reference, "Graphical objects", beside those that are drawn, in order.
const KNOWN: [&str; 60] = [
    "3DFACE",
    "3DSOLID",
    "ACAD_PROXY_ENTITY",
    "ACAD_TABLE",
    "ACIDBLOCKREFERENCE",
    "ARCALIGNEDTEXT",
    "ARC_DIMENSION",
    "ATTDEF",
    "BODY",
    "COORDINATION_MODEL",
    "DGNUNDERLAY",
    "DIMENSION",
    "DWFUNDERLAY",
    "EXTRUDEDSURFACE",
    "FIELD",
    "GEOPOSITIONMARKER",
    "HATCH",
    "HELIX",
    "IMAGE",
    "INSERT",
    "LARGE_RADIAL_DIMENSION",
    "LEADER",
    "LIGHT",
    "LOFTEDSURFACE",
    "MESH",
    "MLEADER",
    "MLEADERSTYLE",
    "MLINE",
    "MORPHSURFACE",
    "MPOLYGON",
    "MTEXT",
    "MULTILEADER",
    "NAVISWORKSMODEL",
    "NURBSURFACE",
    "OLE2FRAME",
    "OLEFRAME",
    "PDFUNDERLAY",
    "PLANESURFACE",
    "POINTCLOUD",
    "POINTCLOUDEX",
    "POLYLINE",
    "POSITIONMARKER",
    "PROXY",
    "RAY",
    "REGION",
    "REVOLVEDSURFACE",
    "RTEXT",
    "SECTION",
    "SECTIONOBJECT",
    "SHAPE",
    "SOLID",
    "SUN",
    "SURFACE",
    "SWEPTSURFACE",
    "TEXT",
    "TOLERANCE",
    "TRACE",
    "VIEWPORT",
    "WIPEOUT",
    "XLINE",
];

/// Tells whether a name is one of DXF beside those that are drawn.
pub(super) fn is_known(name: &[u8]) -> bool {
    KNOWN.binary_search_by(|known| known.as_bytes().cmp(name)).is_ok()
}

/// Names that are drawn, or belong to one that is.
const DRAWN: [&[u8]; 14] = [
    b"LINE",
    b"POINT",
    b"CIRCLE",
    b"ARC",
    b"LWPOLYLINE",
    b"POLYLINE",
    b"ELLIPSE",
    b"SPLINE",
    b"INSERT",
    b"VERTEX",
    b"SEQEND",
    b"ATTRIB",
    b"ENDSEC",
    b"EOF",
];

/// Tells whether a name is none of DXF.
pub(super) fn is_foreign(name: &[u8]) -> bool {
    !is_known(name) && !DRAWN.contains(&name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_in_order() {
        assert!(KNOWN.is_sorted());
        assert!(
            is_known(b"HATCH") && is_known(b"3DFACE") && is_known(b"XLINE") && !is_known(b"LINF")
        );
    }
}
