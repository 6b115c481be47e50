// The example's law as it stands: what an author writes must go through the boundary unchanged.
#include "../../examples/02_contact_law/bouncy.cpp"
