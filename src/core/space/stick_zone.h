/* The cell size that fits the stick zone of a fretting run. */
#ifndef SPACE_STICK_ZONE_H
#define SPACE_STICK_ZONE_H

/* Returns the cell size [mm], at most a sixth smaller than `size`, with which the cells fit a stick
 * zone with the half axes x and z [mm] best. `annulus` is the width of the slip annulus [mm]. */
double arc_stick_zone_cell(double size, double x, double z, double annulus);

#endif
