// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands.h"

#include <kushi/result.h>

namespace kushi {

/// Settles the groom that the arguments name, whose outputs have been checked; the exit status.
int settleGroomFile(const SettleArguments& arguments);

/// A problem if there are flags that only grooms have.
Status noGroomFlags(const SettleArguments& arguments);

}  // namespace kushi
