// SPDX-License-Identifier: BSD-3-Clause

/* A library that is no plug-in. */

int perilymph_nothing(void);

int perilymph_nothing(void) { return 0; }
