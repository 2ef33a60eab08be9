// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Folders in which the workstation keeps patients, plans, recordings and its state.

namespace perilymph::gui {

/// Lets only the user read what this process writes (umask 077). What it writes is of patients.
void keepFilesPrivate();

/// Makes the workstation's folders of data and state readable for their owner only (mode 0700), also
/// those of older versions, and removes what killed programs left in them.
void prepareOwnFolders();

}  // namespace perilymph::gui
