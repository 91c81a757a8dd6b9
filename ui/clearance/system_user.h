#pragma once

#include <QString>

namespace ui {

/// Who works on this computer: the full name that the system has of its user, or else the login name; empty if it has
/// neither.
[[nodiscard]] QString systemUserName();

/// The full name of a record of users ("Jane Doe,Room 12,,", where & stands for the login name with a capital), or else
/// the login name.
[[nodiscard]] QString userNameOf(const QString& record, const QString& login);

}  // namespace ui
