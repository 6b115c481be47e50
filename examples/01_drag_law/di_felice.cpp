#include "di_felice.h"

SIMILITUDE_DRAG_LAW(DiFelice, "org.example.di_felice", "1.0.0", "Single-sphere drag times a power of the gas fraction",
                    "An Author", "Di Felice (1994), Int. J. Multiphase Flow 20, 153")
