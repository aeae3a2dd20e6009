// How fast the driver turns: what velocities and accelerations are told for.
export const driver = $state({rpm: 60});
