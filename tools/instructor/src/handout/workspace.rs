//! The workspace around the answers: a selection of the course's packages, whose
//! manifests have no tests or benches.

use std::collections::BTreeSet;
use std::path::Path;

use pinhole_course::assignment::Assignment;
use pinhole_course::checkout::Checkout;
use pinhole_course::error::{Result, ResultExt};
use toml_edit::{Array, DocumentMut, Item, Table, value};

use super::sources::{add_folder, read_text};
use super::{Files, place_of};

/// The folder of the `pinhole` command.
pub const CLI: &str = "tools/cli";

/// The folder of the program that grades.
pub const INSTRUCTOR: &str = "tools/instructor";

/// A workspace to hand out.
pub struct Workspace<'a> {
    /// The assignment that commands use by default.
    pub assignment: &'a Assignment,
    /// Folders of the packages to include. The packages that they need are added.
    pub packages: &'a [String],
    /// The packages that cargo builds, runs and tests by default.
    pub default: &'a [String],
}

impl Workspace<'_> {
    /// Adds the manifest at the top, the harness, and every package that is not one of
    /// the assignment's.
    pub fn add(&self, files: &mut Files, checkout: &Checkout) -> Result<()> {
        let mut top = self.manifest(checkout, "")?;
        let members = self.members(checkout, &top)?;
        for folder in members.iter().filter(|folder| folder.starts_with("tools/")) {
            let mut own = self.manifest(checkout, folder)?;
            leave_tests_at_home(&mut own);
            files.insert(format!("{folder}/Cargo.toml"), own.to_string().into());
            add_folder(files, checkout, &format!("{folder}/src"), &["rs"])?;
            let templates = format!("{folder}/templates");
            if checkout.root().join(&templates).is_dir() {
                add_folder(files, checkout, &templates, &[])?;
            }
        }
        add_folder(files, checkout, "src", &["rs"])?;

        leave_tests_at_home(&mut top);
        let names = members.iter().map(|folder| self.name(checkout, folder));
        let names = names.collect::<Result<Vec<_>>>()?;
        keep_profiles(&mut top, &reachable(checkout, names)?);
        let paths: BTreeSet<&str> = members.iter().map(String::as_str).chain(["."]).collect();
        if let Some(shared) = top["workspace"]["dependencies"].as_table_mut() {
            shared.retain(|_, item| path_of(item).is_none_or(|path| paths.contains(path)));
        }
        top["workspace"]["metadata"]["pinhole"]["default-assignment"] =
            value(&self.assignment.name);
        top["workspace"]["members"] = list(&members);
        top["workspace"]["default-members"] = list(self.default);
        files.insert("Cargo.toml".into(), top.to_string().into());
        Ok(())
    }

    /// The packages and all packages of ours that they need, by folder.
    fn members(&self, checkout: &Checkout, top: &DocumentMut) -> Result<Vec<String>> {
        let mut members = self.packages.to_vec();
        let mut next = 0;
        while let Some(folder) = members.get(next) {
            let own = self.manifest(checkout, folder)?;
            let needed = own.get("dependencies").and_then(Item::as_table);
            for (name, _) in needed.into_iter().flatten() {
                let shared = top["workspace"]["dependencies"].get(name);
                if let Some(path) = shared.and_then(path_of).filter(|path| *path != ".")
                    && !members.iter().any(|member| member == path)
                {
                    members.push(path.to_owned());
                }
            }
            next += 1;
        }
        Ok(members)
    }

    /// The name of the package in a folder.
    fn name(&self, checkout: &Checkout, folder: &str) -> Result<String> {
        let own = self.manifest(checkout, folder)?;
        let name = own["package"]["name"].as_str();
        Ok(name.unwrap_or(folder).to_owned())
    }

    /// The manifest that a folder of the workspace will have.
    fn manifest(&self, checkout: &Checkout, folder: &str) -> Result<DocumentMut> {
        let own = Path::new(folder).strip_prefix(place_of(self.assignment));
        let here = match own {
            Ok(inside) => self.assignment.folder.join(inside),
            Err(_) => checkout.root().join(folder),
        };
        document(&here.join("Cargo.toml"))
    }
}

/// The folder of a dependency that is one of our packages.
fn path_of(dependency: &Item) -> Option<&str> {
    dependency.get("path")?.as_str()
}

fn document(path: &Path) -> Result<DocumentMut> {
    let parsed: std::result::Result<DocumentMut, toml_edit::TomlError> = read_text(path)?.parse();
    parsed.or_input(
        format_args!("{}", path.display()),
        "restore the file; the instructor's repository has it",
    )
}

fn leave_tests_at_home(manifest: &mut DocumentMut) {
    manifest.remove("bench");
    manifest.remove("test");
    manifest.remove("dev-dependencies");
    if let Some(targets) = manifest.get_mut("target").and_then(Item::as_table_mut) {
        for (_, target) in targets.iter_mut() {
            if let Some(target) = target.as_table_mut() {
                target.remove("dev-dependencies");
            }
        }
    }
    let binaries = manifest
        .get_mut("bin")
        .and_then(Item::as_array_of_tables_mut);
    for binary in binaries.into_iter().flat_map(|all| all.iter_mut()) {
        binary["test"] = value(false);
    }
}

/// Removes profiles of missing packages, because cargo warns about them.
fn keep_profiles(top: &mut DocumentMut, packages: &BTreeSet<String>) {
    let Some(profiles) = top.get_mut("profile").and_then(Item::as_table_mut) else {
        return;
    };
    for (_, profile) in profiles.iter_mut() {
        if let Some(own) = profile.get_mut("package").and_then(Item::as_table_mut) {
            own.retain(|name, _| name == "*" || packages.contains(name));
        }
    }
}

/// These packages and all that the lock file says they need.
fn reachable(checkout: &Checkout, names: Vec<String>) -> Result<BTreeSet<String>> {
    let lock = document(&checkout.root().join("Cargo.lock"))?;
    let packages = lock["package"].as_array_of_tables();
    let mut reachable = BTreeSet::new();
    let mut open = names;
    while let Some(name) = open.pop() {
        if !reachable.insert(name.clone()) {
            continue;
        }
        let named = |package: &&Table| package["name"].as_str() == Some(&name);
        for package in packages.into_iter().flatten().filter(named) {
            let needed = package.get("dependencies").and_then(Item::as_array);
            let needed = needed
                .into_iter()
                .flatten()
                .filter_map(|name| name.as_str());
            // A version follows the name if there are several.
            open.extend(
                needed
                    .filter_map(|name| name.split(' ').next())
                    .map(str::to_owned),
            );
        }
    }
    Ok(reachable)
}

fn list(folders: &[String]) -> Item {
    let mut list: Array = folders.iter().map(String::as_str).collect();
    for folder in list.iter_mut() {
        folder.decor_mut().set_prefix("\n    ");
    }
    list.set_trailing("\n");
    list.set_trailing_comma(true);
    value(list)
}
