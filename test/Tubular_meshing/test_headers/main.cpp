// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The test is that this program compiles and links: see CMakeLists.txt.
int main() {}
