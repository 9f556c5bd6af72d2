//! Rows as Parquet.

use std::mem;
use std::sync::Arc;

use lyapunov_lab::RowFile;
use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use crate::files::Output;

/// Rows that are kept back and written together.
const GROUP: usize = 1 << 16;

/// Writer of rows as Parquet: a column of doubles each, and what the file says about itself in its metadata.
pub(crate) struct Parquet {
    writer: SerializedFileWriter<Output>,
    columns: Vec<Vec<f64>>,
}

impl Parquet {
    /// Begins a file.
    ///
    /// # Errors
    /// Errors of the writer.
    pub(crate) fn of(writer: Output, file: &RowFile) -> Result<Self> {
        let column = |name: &str| {
            let column = Type::primitive_type_builder(name, Physical::DOUBLE);
            column.with_repetition(Repetition::REQUIRED).build().map(Arc::new)
        };
        let fields = file.columns.iter().map(|it| column(&it.name)).collect::<Result<_>>()?;
        let schema = Type::group_type_builder("rows").with_fields(fields).build()?;
        let units: serde_json::Map<String, serde_json::Value> =
            file.columns.iter().map(|it| (it.name.clone(), it.unit.into())).collect();
        let seeds = serde_json::to_string(&file.seeds).unwrap_or_default();
        let said = [
            ("lyapunov", file.lyapunov.to_owned()),
            ("scene", file.scene.clone()),
            ("seeds", seeds),
            ("units", serde_json::Value::Object(units).to_string()),
        ];
        let said = said.map(|(key, value)| KeyValue::new(key.to_owned(), value)).to_vec();
        let properties = WriterProperties::builder().set_key_value_metadata(Some(said)).build();
        let writer = SerializedFileWriter::new(writer, Arc::new(schema), Arc::new(properties))?;
        Ok(Self { writer, columns: vec![Vec::new(); file.columns.len()] })
    }

    /// Writes a row: a number for each column.
    ///
    /// # Errors
    /// Errors of the writer.
    pub(crate) fn write(&mut self, row: impl IntoIterator<Item = f64>) -> Result<()> {
        for (column, number) in self.columns.iter_mut().zip(row) {
            column.push(number);
        }
        if self.columns.first().is_some_and(|column| column.len() >= GROUP) {
            self.put()?;
        }
        Ok(())
    }

    /// Writes the rows that were kept back.
    fn put(&mut self) -> Result<()> {
        let mut group = self.writer.next_row_group()?;
        for column in &mut self.columns {
            if let Some(mut writer) = group.next_column()? {
                let numbers = mem::take(column);
                writer.typed::<DoubleType>().write_batch(&numbers, None, None)?;
                writer.close()?;
            }
        }
        group.close()?;
        Ok(())
    }

    /// Ends the file and returns the writer.
    ///
    /// # Errors
    /// Errors of the writer.
    pub(crate) fn into_inner(mut self) -> Result<Output> {
        self.put()?;
        self.writer.into_inner()
    }
}
