//! TOML cut at its table headers, so that a table can be left out and every other keep
//! its comments and its layout.

/// A table, with the comments that stand right above it.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Its header as written, `[[scene]]` say; empty for what precedes all tables.
    pub header: String,
    /// All of it, header included.
    pub text: String,
}

/// Cuts a document into its tables.
pub fn cut(document: &str) -> Vec<Table> {
    let mut tables = vec![Table {
        header: String::new(),
        text: String::new(),
    }];
    let mut comments = String::new();
    for line in document.lines() {
        if line.starts_with('#') {
            comments.push_str(line);
            comments.push('\n');
            continue;
        }
        let above = std::mem::take(&mut comments);
        if line.starts_with('[') {
            let header = line.split('#').next().unwrap_or(line).trim().to_owned();
            tables.push(Table {
                header,
                text: String::new(),
            });
        }
        let table = tables.last_mut().expect("there is one from the start");
        table.text.push_str(&above);
        table.text.push_str(line);
        table.text.push('\n');
    }
    let table = tables.last_mut().expect("there is one from the start");
    table.text.push_str(&comments);
    tables
}

/// The tables as a document again.
pub fn join(tables: impl IntoIterator<Item = Table>) -> String {
    tables.into_iter().map(|table| table.text).collect()
}

#[cfg(test)]
mod tests {
    use super::{cut, join};

    const DOCUMENT: &str =
        "# all\n\ntitle = 1\n\n# of a\n[a]\nx = [\n  1,\n]\n\n[[b]] # b\ny = 2\n";

    #[test]
    fn a_document_is_the_sum_of_its_tables() {
        assert_eq!(join(cut(DOCUMENT)), DOCUMENT);
    }

    #[test]
    fn a_comment_belongs_to_the_table_below_it() {
        let tables = cut(DOCUMENT);
        let headers: Vec<&str> = tables.iter().map(|table| table.header.as_str()).collect();
        assert_eq!(headers, ["", "[a]", "[[b]]"]);
        assert!(tables[1].text.starts_with("# of a\n"), "{tables:?}");
        assert!(tables[0].text.starts_with("# all\n"), "{tables:?}");
    }
}
