//! As much of JSON Schema (draft 2020-12) as `docs/schema/` uses. A keyword that it does not know
//! is a failure: nothing is passed over.

use serde_json::Value;

/// What of `value` breaks `schema`, which is a part of the schema file `root`.
pub fn broken(root: &Value, schema: &Value, value: &Value, at: &str) -> Vec<String> {
    let mut faults = Vec::new();
    for (keyword, wanted) in schema.as_object().expect("a schema is an object") {
        match keyword.as_str() {
            "$schema" | "$defs" | "title" | "description" => {}
            "$ref" => {
                let name = wanted.as_str().and_then(|r| r.strip_prefix("#/$defs/"));
                let part = &root["$defs"][name.expect("a reference into $defs")];
                assert!(part.is_object(), "{wanted} is defined");
                faults.extend(broken(root, part, value, at));
            }
            "oneOf" => {
                let tried: Vec<_> =
                    items(wanted).map(|option| broken(root, option, value, at)).collect();
                if tried.iter().filter(|faults| faults.is_empty()).count() != 1 {
                    faults.push(format!("{at}: not one of the options: {tried:?}"));
                }
            }
            "type" => {
                let names: Vec<&str> = match wanted {
                    Value::String(name) => vec![name],
                    names => items(names).filter_map(Value::as_str).collect(),
                };
                if !names.iter().any(|name| is_a(value, name)) {
                    faults.push(format!("{at}: {value} is no {names:?}"));
                }
            }
            "const" => check(value == wanted, &mut faults, || format!("{at}: no {wanted}")),
            "enum" => check(items(wanted).any(|v| v == value), &mut faults, || {
                format!("{at}: {value} is none of {wanted}")
            }),
            "minimum" => check(value.as_f64() >= wanted.as_f64(), &mut faults, || {
                format!("{at}: {value} is below {wanted}")
            }),
            "required" => {
                for name in items(wanted).filter_map(Value::as_str) {
                    let there = value.is_null() || value.get(name).is_some();
                    check(there, &mut faults, || format!("{at}: `{name}` is missing"));
                }
            }
            "additionalProperties" => {
                assert_eq!(wanted, false, "only `false` is used");
                for name in value.as_object().into_iter().flat_map(|object| object.keys()) {
                    let known = schema["properties"].get(name).is_some();
                    check(known, &mut faults, || format!("{at}: `{name}` is unknown"));
                }
            }
            "properties" => {
                for (name, part) in wanted.as_object().expect("properties are an object") {
                    if let Some(inner) = value.get(name) {
                        faults.extend(broken(root, part, inner, &format!("{at}.{name}")));
                    }
                }
            }
            "items" => {
                for (i, item) in value.as_array().into_iter().flatten().enumerate() {
                    faults.extend(broken(root, wanted, item, &format!("{at}[{i}]")));
                }
            }
            "minItems" | "maxItems" => {
                if let Some(items) = value.as_array() {
                    let bound = wanted.as_u64().expect("a number of items") as usize;
                    let fits = match keyword.as_str() {
                        "minItems" => items.len() >= bound,
                        _ => items.len() <= bound,
                    };
                    check(fits, &mut faults, || format!("{at}: {} items", items.len()));
                }
            }
            other => panic!("the keyword `{other}` is not known here"),
        }
    }
    faults
}

fn check(holds: bool, faults: &mut Vec<String>, fault: impl FnOnce() -> String) {
    if !holds {
        faults.push(fault());
    }
}

fn items(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().expect("a list").iter()
}

fn is_a(value: &Value, name: &str) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        other => panic!("the type `{other}` is not known here"),
    }
}
