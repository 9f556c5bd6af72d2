//! Structs that no block brings, and their description.

/// A struct of C: each field is told once, to readers of Rust and of the header.
macro_rules! form {
    (
        $(#[doc = $doc:literal])+
        #[derive($($derived:ident),+)]
        pub struct $name:ident<$param:ident $(: $bound:ident)? $(, const $count:ident: usize)?> {
            $($(#[doc = $told:literal])+ pub $field:ident: $type:ty,)+
        }
    ) => {
        $(#[doc = $doc])+
        #[derive($($derived),+)]
        #[repr(C)]
        pub struct $name<$param $(: $bound)? $(, const $count: usize)?> {
            $($(#[doc = $told])+ pub $field: $type,)+
        }

        #[cfg(feature = "describe")]
        impl<$param $(: $bound)? $(, const $count: usize)?> $crate::describe::Form for $name<$param $(, $count)?>
        where
            Self: $crate::describe::CType,
            $($type: $crate::describe::CType,)+
        {
            fn fields() -> std::vec::Vec<$crate::describe::Field<'static>> {
                std::vec![$($crate::describe::Field {
                    name: stringify!($field),
                    c_type: <$type as $crate::describe::CType>::name(),
                    offset: core::mem::offset_of!(Self, $field),
                    about: &[$($told),+],
                }),+]
            }
        }
    };
}

pub(crate) use form;
