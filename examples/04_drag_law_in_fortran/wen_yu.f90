!> Drag of Wen & Yu (1966), Chem. Eng. Prog. Symp. Ser. 62, 100, with Schiller & Naumann's sphere.
module wen_yu
  use, intrinsic :: iso_c_binding, only: c_double, c_int32_t
  implicit none
  private
  real(c_double), parameter :: pi = acos(-1.0_c_double)

contains

  !> K [kg/s] of one particle each, F = K (u - v). Pure: several threads call it at once.
  pure subroutine wen_yu_exchange(rows, exponent, diameter, gas_fraction, slip_speed, gas_density, gas_viscosity, exchange) &
      bind(C, name="wen_yu_exchange")
    integer(c_int32_t), value, intent(in) :: rows
    real(c_double), value, intent(in) :: exponent             ! [-], of the gas fraction
    real(c_double), intent(in) :: diameter(rows)              ! [m]
    real(c_double), intent(in) :: gas_fraction(rows)          ! [-]
    real(c_double), intent(in) :: slip_speed(rows)            ! [m/s]
    real(c_double), intent(in) :: gas_density(rows)           ! [kg/m^3]
    real(c_double), intent(in) :: gas_viscosity(rows)         ! [Pa s]
    real(c_double), intent(out) :: exchange(rows)             ! [kg/s]
    real(c_double) :: reynolds
    integer :: row

    do row = 1, rows
      reynolds = gas_fraction(row) * gas_density(row) * diameter(row) * slip_speed(row) / gas_viscosity(row)   ! superficial
      exchange(row) = 3 * pi * gas_viscosity(row) * diameter(row) * single_sphere(reynolds) * gas_fraction(row)**(-exponent)
    end do
  end subroutine

  !> Drag over Stokes': Schiller & Naumann (1935), Z. Ver. Dtsch. Ing. 77, 318, and C_D = 0.44 from Re = 1000 on.
  elemental real(c_double) function single_sphere(reynolds)
    real(c_double), intent(in) :: reynolds
    if (reynolds < 1000) then
      single_sphere = 1 + 0.15_c_double * reynolds**0.687_c_double
    else
      single_sphere = 0.44_c_double / 24 * reynolds
    end if
  end function

end module
