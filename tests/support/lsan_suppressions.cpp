// SPDX-License-Identifier: GPL-2.0-or-later
// Suppressions for the address sanitizer: GiNaC and CLN never free their tables of constants. Leaks of this project are
// reported.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libcln\nleak:libginac\n"; }
